#include "analyzer/compositional/measures/event_propagation.hpp"

#include <algorithm>

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;
using Release = Node::Release;

}  // namespace

const Why& EventPropagation::unbounded_reason_of(NodeId n) const {
  return view_.times.unbounded_reason[view_.forest.thread_of(n)];
}

bool EventPropagation::certain(NodeId n) {
  const ThreadId thread = view_.forest.thread_of(n);
  // A device is closed until a thread waits for its event.
  const bool opens = node(view_.behaviours.job_start[n]).release == Release::root;
  if (view_.lasts(thread) && (view_.begun[thread] || opens)) return true;
  const Why& unbounded = view_.times.unbounded_reason[thread];
  if (unbounded.empty() && !view_.withholds(Withheld::may_leave_job)) return true;
  if (why_.empty())
    why_ = unbounded.empty() ? compositional::why(Withheld::may_leave_job, problem_.threads[thread].name)
                             : unbounded;
  return false;
}

Sum EventPropagation::node_value(NodeId n) {
  // A job may come back to a wait, and to this node, an unknown number of times.
  const auto [place, fresh] = nodes_.emplace(n, Sum::unbounded());
  if (!fresh) return place->second;
  Sum value = Sum::unbounded();
  if (certain(n)) {
    value = beginning_value(n);
    if (!value.bounded() && why_.empty()) why_ = unbounded_reason_of(n);
  }
  place->second = value;
  return value;
}

Sum EventPropagation::beginning_value(NodeId n) {
  const Beginning& begins = segment(n).beginning;
  if (begins.kind == Beginning::Kind::entry) return step_value(n, problem_.threads[begins.thread].entry);
  const Step& step = step_at(begins.step);
  if (begins.kind == Beginning::Kind::joined) return step_value(n, step.next.front());
  if (at_[begins.step]) return reached(n, begins.step);
  const bool gives_up = begins.kind == Beginning::Kind::give_up;
  return step_value(n, gives_up ? step.next.back() : step.next[static_cast<std::size_t>(begins.arm)]);
}

Sum EventPropagation::step_value(NodeId n, StepId at) {
  const auto known = [&](StepId step) { return steps_.contains({n, step}); };
  const auto leads_on = [&](StepId step) {
    const Kind kind = step_at(step).kind;
    const bool ends = kind == Kind::wait || kind == Kind::fork || kind == Kind::complete || kind == Kind::end;
    return !ends && !at_[step] && !known(step);
  };
  backwards(problem_, at, leads_on, [&](StepId step) {
    if (!known(step)) steps_[{n, step}] = value_of_step(n, step);
  });
  return steps_.at({n, at});
}

Sum EventPropagation::value_of_step(NodeId n, StepId at) {
  const Step& step = step_at(at);
  Sum value = Sum::unbounded();
  if (step.kind == Kind::wait) {
    value = wait_value(n, at);
  } else if (step.kind == Kind::fork) {
    const bool is_end = at_[at];
    value = is_end ? finished(n) : fork_value(n, at);
  } else if (at_[at] || step.kind == Kind::complete) {
    value = reached(n, at);
  } else if (step.kind != Kind::end) {
    value = may_match_nothing(step) ? reached(n, at) : no_way();
    for (StepId next : step.next) {
      const auto after = steps_.find({n, next});
      value = greater(value, after == steps_.end() ? Sum::unbounded() : after->second);
    }
    if (step.kind == Kind::send) value = less(value, sent_value(n, at));
  }
  return value;
}

Sum EventPropagation::sent_value(NodeId n, StepId send) {
  const ChannelId channel = step_at(send).channels.front();
  if (view_.withholds(Withheld::request_withdrawn) && problem_.channels[channel].answer.valid() &&
      may_give_up(problem_, channel)) {
    if (why_.empty()) why_ = compositional::why(Withheld::request_withdrawn);
    return Sum::unbounded();
  }
  NodeId taker{};
  for (NodeId effect : node(n).effects) {
    const auto& sends = node(effect).sends;
    if (std::find(sends.begin(), sends.end(), send) == sends.end()) continue;
    if (taker.valid() || node(effect).release != Release::message) return Sum::unbounded();
    taker = effect;
  }
  if (!taker.valid() || view_.forest.thread_of(taker) == view_.forest.thread_of(n)) return Sum::unbounded();
  // What comes back to a thread in the middle of its job is followed there.
  if (!view_.behaviours.previous[taker].empty()) return Sum::unbounded();
  return node_value(taker);
}

Sum EventPropagation::fork_value(NodeId n, StepId fork) {
  Sum value = Sum::unbounded();
  for (NodeId effect : node(n).effects) {
    if (node(effect).release == Release::fork && node(effect).cause_step == fork)
      value = less(value, node_value(effect));
  }
  return value;
}

Sum EventPropagation::wait_value(NodeId n, StepId wait) {
  const ThreadId thread = view_.forest.thread_of(n);
  if (wait == view_.behaviours.threads[thread].idle_wait) return Sum::unbounded();
  Sum value = no_way();
  bool any = false;
  for (NodeId other : view_.behaviours.threads[thread].nodes) {
    const auto& previous = view_.behaviours.previous[other];
    if (segment(other).beginning.step != wait ||
        std::find(previous.begin(), previous.end(), n) == previous.end())
      continue;
    any = true;
    value = greater(value, node_value(other));
  }
  return any ? value : Sum::unbounded();
}

}  // namespace pal::analyzer::compositional
