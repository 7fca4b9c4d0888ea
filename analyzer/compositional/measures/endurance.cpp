// How long threads go on, and how long after the first that leaves its loop.
#include <algorithm>

#include "analyzer/compositional/causes/job_distance.hpp"
#include "analyzer/compositional/measures/reliable.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;

/// From the end of a block's jobs to the end of the skill.
class Ending {
 public:
  Ending(const Problem& problem, const Forest& forest, const Times& times)
      : problem_(problem), forest_(forest), times_(times) {}

  Sum after(StepId fork, ThreadId leaver) const {
    Sum stopping;
    for (ThreadId block : problem_.steps[fork].threads) {
      if (block == leaver) continue;
      if (problem_.threads[block].can_end) return Sum::unbounded();
      const Nanoseconds within = stops_within(problem_, times_.interference->windows(), block);
      stopping = greater(
          stopping, {within, {Term::Kind::said, {}, {}, {}, "cancelled blocks finish what they have begun"}});
    }
    return stopping + to_completion(fork);
  }

 private:
  Sum finish(NodeId node) const {
    return {times_.nodes[node].finish, {Term::Kind::latest, node, {}, {}, ""}};
  }

  /// From when the blocks are over; all ways must complete the skill without another wait.
  Sum to_completion(StepId fork) const {
    for (const NodeId n : forest_.nodes.ids()) {
      const Segment& segment = forest_.segment_of(forest_.nodes[n]);
      const Source& source = forest_.sources[forest_.nodes[n].source];
      if (source.kind != Source::Kind::joined || source.fork != fork || forest_.nodes[n].cause.valid())
        continue;
      const bool completes =
          segment.waits.empty() && segment.forks.empty() && !segment.ends && sends_freely(segment);
      return completes ? finish(n) : Sum::unbounded();
    }
    return Sum::unbounded();
  }

  bool sends_freely(const Segment& segment) const {
    return std::all_of(segment.steps.begin(), segment.steps.end(), [this](const Segment::Passed& passed) {
      return problem_.steps[passed.step].kind != Kind::send;
    });
  }

  const Problem& problem_;
  const Forest& forest_;
  const Times& times_;
};

}  // namespace

Endurance endurance_of(const Problem& problem, const Forest& forest, const ThreadBehaviours& behaviours,
                       const Times& times) {
  Endurance made;
  made.always = threads_that_endure(problem, forest, behaviours, times, false);
  made.steady = threads_that_endure(problem, forest, behaviours, times, true);
  const Ending ending(problem, forest, times);
  for (const ThreadId t : problem.threads.ids()) {
    if (!behaviours.threads[t].leaves) continue;
    made.leavers.push_back(t);
    const bool known = may_leave(problem, t) && made.steady.reliable[t];
    made.over = greater(made.over, known ? ending.after(fork_of(problem, t), t) : Sum::unbounded());
  }
  return made;
}

}  // namespace pal::analyzer::compositional
