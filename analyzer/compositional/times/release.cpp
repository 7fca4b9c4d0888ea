#include "analyzer/compositional/times/release.hpp"

#include <algorithm>

#include "analyzer/compositional/causes/job_distance.hpp"
#include "analyzer/compositional/times/inter_arrival.hpp"
#include "analyzer/compositional/times/slots.hpp"

namespace pal::analyzer::compositional {
namespace {

using By = Due::By;

/// The later of two.
const Due& later(const Due& one, const Due& other) {
  return other.at > one.at ? other : one;
}

}  // namespace

Nanoseconds Releases::arrival(NodeId node, StepId step) const {
  return latest_arrival(*this, nodes_, node, step);
}

Due Releases::latest(NodeId n, const Table<ThreadId, Why>& unbounded_reason,
                     const Table<ThreadId, bool>& blocked) const {
  const Node& of = node(n);
  const ThreadId thread = forest.thread_of(n);
  const Due none{never};
  if (blocked[thread]) return none;
  const Beginning& begins = segment(n).beginning;
  if (!behaviours.early[n] && !unbounded_reason[thread].empty()) return none;
  switch (of.release) {
    case Node::Release::root:
      return source(n).kind == Source::Kind::event ? of_event(n) : Due{};
    case Node::Release::fork: {
      const Due begun{arrival(of.cause, of.cause_step), By::arrival, of.cause, of.cause_step};
      if (begins.kind != Beginning::Kind::joined) return begun;
      return later(begun, {blocks_over(of, unbounded_reason, blocked), By::blocks, of.cause, of.cause_step});
    }
    case Node::Release::limit: {
      const Nanoseconds limit = step_at(of.cause_step).within.value_or(0);
      return {plus(arrival(of.cause, of.cause_step), limit), By::arrival, of.cause, of.cause_step, limit};
    }
    case Node::Release::message:
      return of_message(n);
  }
  return none;
}

/// The device is closed until its one taker is idle.
Due Releases::of_event(NodeId n) const {
  const Nanoseconds jitter = &nodes_ == &nominal_ ? source(n).jitter : 0;
  const Due late{jitter, By::source, NodeId{}, StepId{}, jitter};
  return later(late, {held_back(forest.thread_of(n)), By::held});
}

Due Releases::of_message(NodeId n) const {
  const Node& of = node(n);
  const ThreadId thread = forest.thread_of(n);
  const bool drains = behaviours.drains[n];
  Due sent{-1, drains ? By::put : By::message, of.cause};
  const NodeTimes& cause = nodes_[of.cause];
  for (StepId send : of.sends) {
    const std::size_t place = place_of(segment(of.cause), send);
    const Nanoseconds at = drains ? cause.worked[place] : cause.effects[place];
    if (at > sent.at) {
      sent.at = at;
      sent.step = send;
    }
  }
  sent.after = way(n).worst;
  if (of.device.valid()) sent.after = plus(sent.after, answer_queue(of.device, sent_channel(n)));
  sent.at = plus(sent.at, sent.after);
  const auto& previous = behaviours.previous[n];
  if (previous.empty()) {
    if (job_start_of(n) != n) return {never};
    const Due idle{first_idle(*this, nominal_, thread), By::idle};
    return later(later(sent, idle), {held_back(thread), By::held});
  }
  Due latest = sent;
  const StepId wait = segment(n).beginning.step;
  for (NodeId before : previous) latest = later(latest, {arrival(before, wait), By::arrival, before, wait});
  return latest;
}

/// When all blocks that a node's cause has started have ended or stopped.
Nanoseconds Releases::blocks_over(const Node& joined, const Table<ThreadId, Why>& unbounded_reason,
                                  const Table<ThreadId, bool>& blocked) const {
  Nanoseconds latest = 0;
  Nanoseconds stopping = 0;
  for (ThreadId block : step_at(joined.cause_step).threads) {
    const ThreadId b = block;
    if (!thread_at(block).can_end) {
      stopping = std::max(stopping, stops_within(problem, interference_.windows(), block));
      continue;
    }
    const bool unbounded = !unbounded_reason[b].empty() || blocked[b];
    if (unbounded || behaviour_of(block).idle_wait.valid() || !ends_straight(problem, block)) return never;
    for (NodeId n : behaviour_of(block).nodes) {
      const Node& begun = node(job_start_of(n));
      if (begun.cause == joined.cause && segment(n).ends) latest = std::max(latest, nodes_[n].finish);
    }
  }
  return plus(latest, stopping);
}

/// A thread that was held in the last send of its job is idle that much later.
Nanoseconds Releases::held_back(ThreadId thread) const {
  Nanoseconds latest = 0;
  for (NodeId n : behaviour_of(thread).nodes) {
    for (const Segment::Passed& passed : segment(n).steps) {
      const Nanoseconds until = held_until(*this, nominal_, n, passed.step);
      latest = std::max(latest, until >= never ? never : until - source(n).period);
    }
  }
  return latest;
}

}  // namespace pal::analyzer::compositional
