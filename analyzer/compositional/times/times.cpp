#include "analyzer/compositional/times/times.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "analyzer/compositional/times/inter_arrival.hpp"
#include "analyzer/compositional/times/interference.hpp"
#include "analyzer/compositional/times/release.hpp"
#include "analyzer/compositional/times/since_event.hpp"
#include "analyzer/compositional/times/slots.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;

constexpr int most_rounds = 400;
constexpr int every_priority = std::numeric_limits<int>::max();
constexpr int no_priority = std::numeric_limits<int>::min();

/// The nodes with their earliest releases, and as if nothing ever had to wait.
Table<NodeId, NodeTimes> unhindered(const AnalysisContext& context, const Table<StepId, bool>& at,
                                    const std::function<bool()>& stop) {
  Table<NodeId, NodeTimes> nodes(context.forest.nodes.size());
  const Table<NodeId, Nanoseconds> earliest = earliest_releases(context, stop);
  for (const NodeId n : nodes.ids()) {
    const Segment& of = context.segment(n);
    NodeTimes& mine = nodes[n];
    mine.earliest = mine.latest = earliest[n];
    mine.effects.assign(of.steps.size(), NodeTimes::unknown);
    mine.arrivals.assign(of.waits.size(), 0);
    for (std::size_t s = 0; s < of.steps.size(); ++s) {
      const Step& step = context.step_at(of.steps[s].step);
      if (at[of.steps[s].step] || is_always_timed(step)) mine.effects[s] = 0;
    }
    mine.worked = mine.effects;
  }
  return nodes;
}

/// Raises all times together until they agree. Each iteration derives the latest releases from the latest
/// effects, and these from the work that the releases can pile up (J. C. Palencia, M. González Harbour 1998;
/// the argument that the least solution bounds every run is in docs/internals/compositional.md).
class Solver : private AnalysisContext {
 public:
  Solver(const AnalysisContext& context, const Table<StepId, bool>& at, const std::function<bool()>& stop,
         WindowEnds ends)
      : AnalysisContext(context),
        stop_(stop),
        nodes_(unhindered(context, at, stop)),
        interference_(context, nodes_, stop, ends),
        releases_(*this, nodes_, interference_) {}

  Times run() {
    times_.unbounded_reason.resize(problem.threads.size());
    times_.blocked.assign(problem.threads.size(), false);
    for (const ThreadId t : problem.threads.ids())
      times_.unbounded_reason[t] = behaviours.threads[t].unbounded_reason;
    since_.assign(problem.threads.size(), {});
    const Slots slots(*this);
    do {
      solve();
      times_.nodes = nodes_;
      if (times_.interrupted) return std::move(times_);
    } while (finds_unbounded_threads(slots));
    name_roots();
    find_inter_arrivals(*this, times_);
    times_.since_event = since_events(*this, times_, interference_);
    interference_.go_on();
    times_.interference = std::make_shared<const Interference>(interference_);
    return std::move(times_);
  }

 private:
  NodeTimes& times(NodeId n) { return nodes_[n]; }

  Nanoseconds latest_release(NodeId n) const {
    return releases_.latest(n, times_.unbounded_reason, times_.blocked).at;
  }

  /// The work until what is timed of a node: each once, ascending.
  std::vector<Nanoseconds> timed_parts(NodeId n) const {
    const Segment& of = segment(n);
    std::vector<Nanoseconds> parts{of.worst};
    for (std::size_t s = 0; s < of.steps.size(); ++s) {
      if (nodes_[n].effects[s] != NodeTimes::unknown) parts.push_back(of.steps[s].worst);
    }
    for (const auto& wait : of.waits) parts.push_back(wait.worst);
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    return parts;
  }

  bool update(NodeId n) {
    NodeTimes& mine = times(n);
    const NodeTimes before = mine;
    mine.latest = std::max(mine.latest, latest_release(n));
    // Later than what can pile up: something on the way does not keep up.
    if (mine.latest < never && mine.latest - mine.earliest > interference_.greatest_jitter(n))
      mine.latest = never;
    interference_.announce(n, mine);
    const Segment& of = segment(n);
    const Nanoseconds keeps = mine.latest >= never ? 0 : interference_.blocking(n);
    const std::vector<Nanoseconds> parts = timed_parts(n);
    const std::vector<Nanoseconds> ends = mine.latest >= never || of.steps.empty()
                                              ? std::vector<Nanoseconds>()
                                              : interference_.finishes(n, parts, keeps);
    const auto done = [&](Nanoseconds part) {
      if (mine.latest >= never) return never;
      if (of.steps.empty()) return mine.latest;  // reaching a wait needs no processor
      return ends[static_cast<std::size_t>(std::lower_bound(parts.begin(), parts.end(), part) -
                                           parts.begin())];
    };
    for (std::size_t s = 0; s < of.steps.size(); ++s) {
      if (mine.effects[s] == NodeTimes::unknown) continue;
      mine.worked[s] = std::max(mine.worked[s], done(of.steps[s].worst));
      mine.effects[s] =
          std::max({mine.effects[s], mine.worked[s], held_until(*this, nodes_, n, of.steps[s].step)});
    }
    for (std::size_t w = 0; w < of.waits.size(); ++w) {
      mine.arrivals[w] = std::max(
          {mine.arrivals[w], done(of.waits[w].worst), sent_before(*this, mine, n, of.waits[w].step)});
    }
    mine.finish = std::max(mine.finish, done(of.worst));
    return mine.latest != before.latest || mine.finish != before.finish || mine.effects != before.effects ||
           mine.worked != before.worked || mine.arrivals != before.arrivals;
  }

  /// Whether one of its sends may have to wait for longer than is known: its taker may be on any processor.
  bool held_longer(NodeId n) const {
    const Segment& of = segment(n);
    const NodeTimes& mine = nodes_[n];
    for (std::size_t s = 0; s < of.steps.size(); ++s) {
      if (mine.effects[s] == NodeTimes::unknown) continue;
      if (held_until(*this, nodes_, n, of.steps[s].step) > mine.effects[s]) return true;
    }
    return false;
  }

  /// The greatest priority of the threads that a change of a node's release can delay. They run on its
  /// processor. If that is not preemptive, they may have any priority.
  int delays_up_to(const Thread& thread) const {
    const bool preemptive = problem.processors[thread.processor].preemptive;
    return preemptive ? thread.priority : every_priority;
  }

  void solve() {
    for (const NodeId n : nodes_.ids()) interference_.announce(n, nodes_[n]);
    Table<ProcessorId, int> dirty(problem.processors.size(), every_priority);  // delays_up_to()
    for (int iteration = 0; iteration < most_rounds; ++iteration) {
      find_overlaps(dirty);
      Table<ProcessorId, int> now = dirty;
      dirty.assign(dirty.size(), no_priority);
      bool changed = false;
      for (const NodeId n : nodes_.ids()) {
        if (stop_ && stop_()) {
          times_.interrupted = true;
          return;
        }
        const Thread& thread = thread_of(n);
        const ProcessorId processor = thread.processor;
        const Nanoseconds latest = std::max(times(n).latest, latest_release(n));
        const bool delayed = thread.priority <= now[processor];
        if (!delayed && latest == times(n).latest && !held_longer(n)) continue;
        if (update(n)) {
          changed = true;
          dirty[processor] = std::max(dirty[processor], delays_up_to(thread));
          now[processor] = std::max(now[processor], delays_up_to(thread));
        }
      }
      if (!changed) return;
    }
    // Times that go on rising have no bound: give them up, and see what is left.
    for (const NodeId n : nodes_.ids()) {
      NodeTimes& mine = times(n);
      mine.latest = mine.finish = never;
      for (Nanoseconds& each : mine.effects) each = each == NodeTimes::unknown ? each : never;
      mine.worked = mine.effects;
      mine.arrivals.assign(mine.arrivals.size(), never);
      interference_.announce(n, mine);
    }
  }

  /// Tells the interference what does not overlap by now. `dirty`: where it is less than before, which may
  /// delay any thread there.
  void find_overlaps(Table<ProcessorId, int>& dirty) {
    Table<ThreadId, bool> done_before_next;
    for (const ThreadId t : behaviours.threads.ids())
      done_before_next.push_back(is_done_before_next(*this, nodes_, t));
    Table<SourceId, bool> in_turn(forest.sources.size(), true);
    for (const NodeId n : forest.nodes.ids()) {
      const SourceId source = forest.nodes[n].source;
      const Nanoseconds period = forest.sources[source].period;
      if (period < never && nodes_[n].finish >= period) in_turn[source] = false;
    }
    for (const NodeId n : nodes_.ids()) {
      if (in_turn_.empty()) break;
      const SourceId source = forest.nodes[n].source;
      const ProcessorId processor = thread_of(n).processor;
      if (in_turn_[source] != in_turn[source]) dirty[processor] = every_priority;
    }
    interference_.find_order(done_before_next, in_turn, stop_);
    interference_.find_bursts(nodes_, done_before_next, times_.blocked);
    in_turn_ = in_turn;
  }

  /// Whether something is found that the times do not count with yet.
  bool finds_unbounded_threads(const Slots& slots) {
    bool found = false;
    const auto unbounded_reason = [this](ThreadId thread) -> Why& { return times_.unbounded_reason[thread]; };
    std::vector<Slots::UnboundedThread> fresh;
    for (Slots::UnboundedThread& each : slots.unbounded_threads(times_)) {
      const ThreadId thread = each.thread;
      found = found || unbounded_reason(each.thread).empty() || (each.blocked && !times_.blocked[thread]);
      if (each.blocked) times_.blocked[thread] = true;
      if (!unbounded_reason(each.thread).empty()) continue;
      unbounded_reason(each.thread) = each.why;
      fresh.push_back(std::move(each));
    }
    for (const Slots::UnboundedThread& each : fresh) {
      for (ThreadId taker : each.takers) {
        if (taker != each.thread && !unbounded_reason(taker).empty()) since_[each.thread] = taker;
      }
    }
    return found;
  }

  /// Adds the original reason to each reason that follows from another.
  void name_roots() {
    const Table<ThreadId, Why> own = times_.unbounded_reason;
    for (const ThreadId t : own.ids()) {
      std::set<ThreadId> seen{t};
      ThreadId at = t;
      for (ThreadId next = since_[t]; next.valid() && seen.insert(next).second; next = since_[next])
        at = next;
      if (at != t) times_.unbounded_reason[t] = since(own[t], own[at]);
    }
  }

  const std::function<bool()>& stop_;
  Table<NodeId, NodeTimes> nodes_;
  Interference interference_;
  Releases releases_;
  Times times_;
  Table<SourceId, bool> in_turn_;    // by source, as it was last found
  Table<ThreadId, ThreadId> since_;  // the thread that makes it unbounded
};

}  // namespace

bool is_always_timed(const Step& step) {
  return step.kind == Kind::send || step.kind == Kind::set || step.kind == Kind::wait ||
         step.kind == Kind::complete || may_match_nothing(step);
}

std::size_t place_of(const Segment& segment, StepId step) {
  for (std::size_t s = 0; s < segment.steps.size(); ++s) {
    if (segment.steps[s].step == step) return s;
  }
  return segment.steps.size();
}

Times times_of(const Problem& problem, const Forest& forest, const ThreadBehaviours& behaviours,
               const Table<StepId, bool>& at, const std::function<bool()>& stop, WindowEnds ends) {
  return Solver({problem, forest, behaviours}, at, stop, ends).run();
}

Nanoseconds latest_effect(const Forest& forest, const Table<NodeId, NodeTimes>& nodes, NodeId node,
                          StepId step) {
  const std::size_t place = place_of(forest.segment_of(forest.nodes[node]), step);
  const auto& effects = nodes[node].effects;
  return place < effects.size() && effects[place] != NodeTimes::unknown ? effects[place] : never;
}

Nanoseconds earliest_effect(const Forest& forest, const Times& times, NodeId node, StepId step) {
  const Segment& segment = forest.segment_of(forest.nodes[node]);
  const std::size_t place = place_of(segment, step);
  return times.nodes[node].earliest + (place < segment.steps.size() ? segment.steps[place].best : 0);
}

}  // namespace pal::analyzer::compositional
