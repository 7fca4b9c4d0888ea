#include "analyzer/compositional/causes/analysis_context.hpp"

#include <algorithm>
#include <set>

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;
using Release = Node::Release;

constexpr int most_context_rounds = 50;

Nanoseconds best_arrival(const Segment& segment, StepId wait) {
  for (const Segment::Arrival& each : segment.waits) {
    if (each.step == wait) return each.best;
  }
  for (const Segment::Arrival& each : segment.forks) {
    if (each.step == wait) return each.best;
  }
  return 0;
}

Nanoseconds best_effect(const Segment& segment, StepId step) {
  for (const Segment::Passed& each : segment.steps) {
    if (each.step == step) return each.best;
  }
  return 0;
}

/// From those that are known of its causes.
Nanoseconds earliest_release(const AnalysisContext& context, NodeId n,
                             const Table<NodeId, Nanoseconds>& known) {
  const Node& node = context.node(n);
  const auto at = [&known](NodeId other) { return known[other]; };
  Nanoseconds value = 0;
  if (node.release == Release::message) value = plus(at(node.cause), earliest_after_cause(context, n));
  const auto& previous = context.behaviours.previous[n];
  const Beginning& begins = context.segment(n).beginning;
  if (!previous.empty()) {
    Nanoseconds soonest = never;
    for (NodeId before : previous)
      soonest = std::min(soonest, plus(at(before), best_arrival(context.segment(before), begins.step)));
    const bool gives_up = begins.kind == Beginning::Kind::give_up;
    value = std::max(value, plus(soonest, gives_up ? context.step_at(begins.step).within.value_or(0) : 0));
  } else if (node.release == Release::fork) {
    value = plus(at(node.cause), earliest_after_cause(context, n));
  }
  return value;
}

}  // namespace

Nanoseconds earliest_after_cause(const AnalysisContext& context, NodeId n) {
  const Node& node = context.node(n);
  const Segment& cause = context.segment(node.cause);
  switch (node.release) {
    case Release::root:
      return 0;
    case Release::message: {
      Nanoseconds sent = never;
      for (StepId send : node.sends) sent = std::min(sent, best_effect(cause, send));
      return plus(sent, context.way(n).best);
    }
    case Release::limit: {
      const bool gives_up = context.segment(n).beginning.kind == Beginning::Kind::give_up;
      return plus(best_arrival(cause, node.cause_step),
                  gives_up ? context.step_at(node.cause_step).within.value_or(0) : 0);
    }
    case Release::fork:
      return best_arrival(cause, node.cause_step);
  }
  return 0;
}

std::vector<NodeId> AnalysisContext::endings_before_idle(ThreadId thread) const {
  std::vector<NodeId> found;
  std::set<NodeId> seen;
  for (ThreadId t = thread; t.valid(); t = thread_at(t).parent) {
    for (const StartEnding& of : behaviours.start_endings[t])
      if (seen.insert(of.node).second && !in_job(of.own)) found.push_back(of.node);
  }
  return found;
}

std::vector<NodeId> AnalysisContext::endings_before_first(SourceId loop) const {
  const Source& of = forest.sources[loop];
  if (of.kind != Source::Kind::loop) return {};
  std::vector<NodeId> found = endings_before_idle(of.thread);
  for (const Source::Feed& feed : of.feeds) {
    if (!feed.node.valid() || source(feed.node).kind != Source::Kind::start) continue;
    const std::vector<NodeId>& endings = behaviours.endings[node(feed.node).source];
    found.insert(found.end(), endings.begin(), endings.end());
  }
  return found;
}

bool may_give_up(const Problem& problem, ChannelId request) {
  const ChannelId answer = problem.channels[request].answer;
  return std::any_of(problem.steps.begin(), problem.steps.end(), [&](const Step& step) {
    return step.kind == Kind::wait && step.within &&
           std::find(step.channels.begin(), step.channels.end(), answer) != step.channels.end();
  });
}

Range AnalysisContext::device_time(DeviceId device) const {
  const auto& behaviour = problem.devices[device].behaviour;
  if (const auto* request = std::get_if<pan::RequestDevice>(&behaviour))
    return {request->answer.best.count(), request->answer.worst.count()};
  if (const auto* frames = std::get_if<pan::FrameDevice>(&behaviour))
    return {frames->collecting.count(), frames->period.count() + frames->collecting.count()};
  return {0, never};
}

Range AnalysisContext::way(NodeId n) const {
  if (node(n).device.valid()) return device_time(node(n).device);
  return latency(problem, sent_channel(n), forest.thread_of(node(n).cause), forest.thread_of(n));
}

Nanoseconds AnalysisContext::answer_queue(DeviceId device, ChannelId request) const {
  const Device& of = problem.devices[device];
  const auto* behaviour = std::get_if<pan::RequestDevice>(&of.behaviour);
  if (behaviour == nullptr) return 0;
  // It takes any of those that wait: the others could be served again and again before this one.
  if (of.requests.size() > 1) return never;
  return may_give_up(problem, request) ? behaviour->answer.worst.count() : 0;
}

/// Lower bounds, each got from lower bounds; the last ones are the greatest.
Table<NodeId, Nanoseconds> earliest_releases(const AnalysisContext& context,
                                             const std::function<bool()>& stop) {
  Table<NodeId, Nanoseconds> known(context.forest.nodes.size(), 0);
  for (int iteration = 0; iteration < most_context_rounds; ++iteration) {
    bool changed = false;
    for (const NodeId n : known.ids()) {
      if (stop && stop()) return known;
      const Nanoseconds value = earliest_release(context, n, known);
      changed = changed || value != known[n];
      known[n] = value;
    }
    if (!changed) break;
  }
  return known;
}

}  // namespace pal::analyzer::compositional
