#include "analyzer/compositional/measures/staleness.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "analyzer/compositional/measures/reasons.hpp"
#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;

/// Whether two threads are blocks of one CONCURRENT.
bool beside(const Problem& problem, ThreadId one, ThreadId other) {
  return std::any_of(problem.steps.begin(), problem.steps.end(), [one, other](const Step& step) {
    return std::count(step.threads.begin(), step.threads.end(), one) > 0 &&
           std::count(step.threads.begin(), step.threads.end(), other) > 0;
  });
}

class Staleness {
 public:
  Staleness(const View& view, ConditionId condition, ThreadId reader)
      : view_(view), problem_(view.problem), condition_(condition), reader_(reader) {
    at_.resize(problem_.steps.size());
    for (const StepId s : at_.ids()) at_[s] = sets(s);
    setters_ = owners(view, at_);
  }

  Bound run() const {
    if (setters_.empty()) return no_bound(why(Withheld::never_set));
    // A value is no older than the last set of any one of them: what the others set only makes it younger.
    std::optional<Bound> least;
    for (ThreadId setter : setters_) {
      const Bound of = distance_of_sets(setter);
      if (!least || of.sum.value() < least->sum.value()) least = of;
    }
    return *least;
  }

 private:
  const Step& step_at(StepId step) const { return problem_.steps[step]; }
  const ThreadBehaviour& behaviour(ThreadId thread) const { return view_.behaviours.threads[thread]; }
  const Segment& segment(NodeId n) const { return view_.forest.segment_of(view_.forest.nodes[n]); }
  bool sets(StepId step) const {
    return step_at(step).kind == Kind::set && step_at(step).condition == condition_;
  }

  Bound distance_of_sets(ThreadId setter) const {
    const std::string& name = problem_.threads[setter].name;
    const StatementOccurrences occurrences(view_, setter, at_);
    const bool lasts = outlasts(view_, setter, reader_);
    if (!lasts || !occurrences.in_every_job() || occurrences.in_jobs().empty()) {
      Why found = why_not_again(view_, setter, occurrences, lasts, "a set of the condition");
      if (view_.forest.withholds(found)) return no_bound(std::move(found));
    }
    Sum soonest = Sum::unbounded();
    for (const StepEffect& effect : occurrences.in_jobs())
      soonest = less(soonest, earliest(view_, effect.node, effect.step));
    const Sum& set_again = replaced(view_, occurrences, setter, reader_);
    const Sum next = occurrences.next_or_end(set_again);
    if (!next.bounded())
      return no_bound(with_unbounded_reason(why(Withheld::pause_unknown, name), view_, setter));
    return {greater(next - soonest, until_first(setter, occurrences.first_or_end(set_again))),
            why(Withheld::first_set_unknown, name)};
  }

  /// Until the first set in a job a value is as old as the skill, or as what was set before the jobs.
  Sum until_first(ThreadId setter, const Sum& first) const {
    const ThreadId parent = problem_.threads[setter].parent;
    const ThreadId above = !parent.valid() ? setter : parent;
    Sum soonest = Sum::unbounded();
    Sum last;
    for (NodeId n : behaviour(above).nodes) {
      const SourceId source = view_.forest.nodes[n].source;
      const bool at_start = view_.forest.sources[source].kind == Source::Kind::start;
      if (!at_start || in_job(view_, n)) continue;
      for (const Segment::Passed& passed : segment(n).steps) {
        if (!sets(passed.step)) continue;
        const Sum effect = latest(view_, n, passed.step);
        if (!effect.bounded()) continue;  // after the blocks
        soonest = less(soonest, earliest(view_, n, passed.step));
        last = greater(last, effect);
      }
    }
    if (!soonest.bounded() || !first.bounded() || !sets_before_jobs(above)) return first;
    // Or the skill ends before the first of them.
    const AnalysisContext context{problem_, view_.forest, view_.behaviours};
    for (NodeId n : context.endings_before_idle(above)) last = greater(last, finish(view_, n));
    return greater(last, first - soonest);
  }

  /// Every way from the beginning of a module to its first idle wait or CONCURRENT sets the condition.
  bool sets_before_jobs(ThreadId thread) const {
    return !follow(problem_, {problem_.threads[thread].entry}, [&](StepId at) {
      if (sets(at)) return Course::ends;
      return at == behaviour(thread).idle_wait || step_at(at).kind == Kind::fork ? Course::found
                                                                                 : Course::goes_on;
    });
  }

  const View& view_;
  const Problem& problem_;
  ConditionId condition_;
  ThreadId reader_;
  Table<StepId, bool> at_;  // the sets
  std::set<ThreadId> setters_;
};

}  // namespace

bool outlasts(const View& view, ThreadId thread, ThreadId reader) {
  if (!goes_on(view, thread)) return false;
  const auto behaviour = [&view](ThreadId of) { return view.behaviours.threads[of]; };
  if (thread == reader || !behaviour(thread).may_be_cancelled) return true;
  const Thread& lasting = view.problem.threads[thread];
  const Thread& reads = view.problem.threads[reader];
  // Blocks that end are over before those beside them are cancelled.
  if (lasting.can_end || !reads.can_end || !beside(view.problem, thread, reader)) return false;
  return !behaviour(lasting.parent).may_be_cancelled;
}

const Sum& replaced(const View& view, const StatementOccurrences& sets, ThreadId setter, ThreadId reader) {
  const Thread& sets_it = view.problem.threads[setter];
  const Thread& reads_it = view.problem.threads[reader];
  const bool gives_way = sets_it.processor == reads_it.processor &&
                         view.problem.processors[sets_it.processor].preemptive &&
                         reads_it.priority < sets_it.priority;
  return gives_way ? sets.released() : sets.latest();
}

Bound value_age(const View& view, ConditionId condition, ThreadId reader) {
  return Staleness(view, condition, reader).run();
}

}  // namespace pal::analyzer::compositional
