#include "analyzer/compositional/times/slots.hpp"

#include <algorithm>

#include "pal/support/duration_text.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;

/// Latest effect of the take that begins a node.
Nanoseconds taken(const Table<NodeId, NodeTimes>& nodes, NodeId node) {
  return nodes[node].effects.front();
}

/// Whether a thread waits without a limit in its jobs.
bool waits_for_others(const AnalysisContext& context, ThreadId thread) {
  const ThreadBehaviour& of = context.behaviour_of(thread);
  return std::any_of(of.nodes.begin(), of.nodes.end(), [&](NodeId n) {
    const Segment& segment = context.segment(n);
    return context.in_job(n) &&
           (!segment.forks.empty() ||
            std::any_of(segment.waits.begin(), segment.waits.end(), [&](const Segment::Arrival& wait) {
              return wait.step != of.idle_wait && !context.step_at(wait.step).within;
            }));
  });
}

/// When a job of the thread is done at the latest, after the nominal instant of the job's source.
Nanoseconds done(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes, ThreadId thread) {
  const ThreadBehaviour& of = context.behaviour_of(thread);
  Nanoseconds last = 0;
  for (NodeId n : of.nodes) {
    if (context.in_job(n)) last = std::max(last, nodes[n].finish);
  }
  if (!waits_for_others(context, thread)) return last;
  // The threads that it has set to work, and those that end the skill, may leave it waiting till then.
  for (NodeId n : context.behaviours.endings[context.node(of.job_starts.front()).source]) {
    if (context.nearest(n, thread).valid()) last = std::max(last, nodes[n].finish);
  }
  return last;
}

/// When the next one may be due at the earliest, after the same instant.
Nanoseconds next_due(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes, ThreadId thread) {
  const std::vector<NodeId>& job_starts = context.behaviour_of(thread).job_starts;
  Nanoseconds soonest = never;
  for (NodeId n : job_starts) soonest = std::min(soonest, nodes[n].earliest);
  return plus(context.source(job_starts.front()).period, soonest);
}

/// Why a thread that begins jobs in several ways has no bound.
Why why_in_several_ways(const AnalysisContext& context, ThreadId thread) {
  std::vector<std::string> clients;
  for (NodeId n : context.behaviour_of(thread).job_starts) {
    const Beginning& begins = context.segment(n).beginning;
    if (begins.kind != Beginning::Kind::arm) continue;
    const ChannelId channel = context.step_at(begins.step).channels[static_cast<std::size_t>(begins.arm)];
    const std::string& name = sender_name(context.problem, channel);
    if (std::find(clients.begin(), clients.end(), name) == clients.end()) clients.push_back(name);
  }
  const std::string& server = context.thread_at(thread).name;
  if (clients.size() < 2) return why(Withheld::several_ways, server);
  std::string names = clients.front();
  for (std::size_t i = 1; i < clients.size(); ++i)
    names += (i + 1 == clients.size() ? " and " : ", ") + clients[i];
  return why(Withheld::several_clients, server, clients.size(), names);
}

bool sent_by(const Node& taker, StepId send) {
  return std::find(taker.sends.begin(), taker.sends.end(), send) != taker.sends.end();
}

}  // namespace

bool take_in_time(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes, NodeId node,
                  Nanoseconds put) {
  const Nanoseconds period = context.source(node).period;
  return taken(nodes, node) < (period == never ? never : plus(period, put));
}

bool is_done_before_next(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes,
                         ThreadId thread) {
  const ThreadBehaviour& behaviours = context.behaviour_of(thread);
  if (behaviours.job_starts.empty()) return true;
  if (!behaviours.one_job) return false;
  const Source& of = context.source(behaviours.job_starts.front());
  const bool itself = !context.node(behaviours.job_starts.front()).cause.valid();
  if (of.kind == Source::Kind::loop && of.thread == thread && itself) return true;
  return of.period == never || done(context, nodes, thread) < next_due(context, nodes, thread);
}

Nanoseconds sent_before(const AnalysisContext& context, const NodeTimes& times, NodeId node, StepId wait) {
  const Segment& of = context.segment(node);
  Nanoseconds latest = 0;
  for (std::size_t s = 0; s < of.steps.size(); ++s) {
    const Step& step = context.step_at(of.steps[s].step);
    if (step.kind == Kind::send && step.next.front() == wait) latest = std::max(latest, times.effects[s]);
  }
  return latest;
}

Nanoseconds held_until(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes, NodeId node,
                       StepId send) {
  const Nanoseconds period = context.source(node).period;
  if (context.step_at(send).kind != Kind::send || period == never) return 0;
  const ChannelId channel = context.step_at(send).channels.front();
  if (context.behaviours.never_full[channel]) return 0;
  Nanoseconds latest = 0;
  for (NodeId effect : context.node(node).effects) {
    const Node& taker = context.node(effect);
    if (taker.device.valid() || !sent_by(taker, send)) continue;
    const Nanoseconds end = taken(nodes, effect);
    latest = std::max(latest, end >= never ? never : end - period);
  }
  return latest;
}

Slots::Slots(const AnalysisContext& context) : context_(context), puts_(context.problem.channels.size()) {
  for (const NodeId n : context.forest.nodes.ids()) {
    for (const Segment::Passed& passed : context.segment(n).steps) {
      const Step& step = context.step_at(passed.step);
      if (step.kind == Kind::send) puts_[step.channels.front()].push_back({n, passed.step});
    }
  }
  for (const std::vector<StepEffect>& puts : puts_) exclusive_.push_back(are_exclusive(context, puts));
}

/// Whether every message of the channel is taken before the next is put.
bool Slots::is_free(const Table<NodeId, NodeTimes>& nodes, ChannelId channel) const {
  const Channel& of = context_.problem.channels[channel];
  if (of.receiver_device.valid() && !of.served) return true;
  if (context_.behaviours.never_full[channel]) return true;
  const auto& puts = puts_[channel];
  if (puts.empty()) return true;
  if (!exclusive_[channel]) return false;
  if (context_.source(puts.front().node).period == never) return true;  // one message, ever
  Nanoseconds soonest = never;
  bool one_node = true;
  for (const StepEffect& put : puts) {
    const Segment& segment = context_.segment(put.node);
    soonest = std::min(soonest, nodes[put.node].earliest + segment.steps[place_of(segment, put.step)].best);
    one_node = one_node && put.node == puts.front().node;
  }
  return std::all_of(puts.begin(), puts.end(),
                     [&](const StepEffect& put) { return is_taken_in_time(nodes, put, soonest, one_node); });
}

/// Whether a put of a job is taken before the put of the next job, which comes at `soonest` at the earliest.
/// Also true if it is known what that put waits for.
bool Slots::is_taken_in_time(const Table<NodeId, NodeTimes>& nodes, StepEffect put, Nanoseconds soonest,
                             bool may_hold) const {
  bool known = false;
  for (NodeId effect : context_.node(put.node).effects) {
    if (!sent_by(context_.node(effect), put.step)) continue;
    known = true;
    const bool held = may_hold && may_be_held(nodes, put, effect);
    if (!take_in_time(context_, nodes, effect, soonest) && !held) return false;
  }
  return known;
}

/// Whether it is known what a wait for the slot does: the send ends its thread's only kind of job.
bool Slots::may_be_held(const Table<NodeId, NodeTimes>& nodes, StepEffect put, NodeId taker) const {
  const ThreadBehaviour& of = context_.behaviour_of(context_.forest.thread_of(put.node));
  return taken(nodes, taker) < never && of.job_starts.size() == 1 && !of.waits_within &&
         context_.job_start_of(put.node) == of.job_starts.front() &&
         context_.step_at(put.step).next.front() == of.idle_wait;
}

std::vector<ThreadId> Slots::takers_of(StepEffect put) const {
  std::vector<ThreadId> threads;
  for (NodeId effect : context_.node(put.node).effects) {
    if (sent_by(context_.node(effect), put.step)) threads.push_back(context_.forest.thread_of(effect));
  }
  return threads;
}

std::vector<Slots::UnboundedThread> Slots::unbounded_threads(const Times& times) const {
  std::vector<UnboundedThread> found;
  for (const ChannelId c : puts_.ids()) {
    if (is_free(times.nodes, c)) continue;
    for (const StepEffect& put : puts_[c]) {
      const StatementId statement = context_.step_at(put.step).statement;
      const std::string send = statement.valid() ? context_.problem.statements[statement].text : "a send";
      found.push_back({context_.forest.thread_of(put.node), true,
                       why(Withheld::slot_full, context_.thread_of(put.node).name, send), takers_of(put)});
    }
  }
  for (const ThreadId t : context_.problem.threads.ids()) {
    const ThreadBehaviour& of = context_.behaviours.threads[t];
    if (!of.waits_within || of.job_starts.empty() || of.asked_by_one) continue;
    if (!of.one_job) {
      found.push_back({t, false, why_in_several_ways(context_, t), {}});
    } else if (!is_done_before_next(context_, times.nodes, t)) {
      const Nanoseconds last = done(context_, times.nodes, t);
      const Nanoseconds next = next_due(context_, times.nodes, t);
      const std::string& name = context_.thread_at(t).name;
      found.push_back({t,
                       false,
                       last >= never ? why(Withheld::job_without_end, name)
                                     : why(Withheld::job_too_long, name, to_text(Duration(last)),
                                           to_text(Duration(next))),
                       {}});
    }
  }
  std::erase_if(found, [this](const UnboundedThread& each) { return !context_.forest.withholds(each.why); });
  return found;
}

}  // namespace pal::analyzer::compositional
