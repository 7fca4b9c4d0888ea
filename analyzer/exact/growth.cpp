#include "analyzer/exact/growth.hpp"

#include <algorithm>

namespace pal::analyzer {
namespace {

/// Classes that are merged only with their equals are many where several clocks drift; mostly a way round is
/// found among the first.
constexpr std::size_t most_classes = 50'000;

Range longest(const Range& range) {
  return {range.worst, range.worst};
}

/// Some of the runs: those in which all that computes and travels takes as long as it may. Their classes are
/// exact, also where threads are preempted.
Problem slowest(Problem problem) {
  for (Step& step : problem.steps) {
    step.cost = longest(step.cost);
    step.give_up_cost = longest(step.give_up_cost);
  }
  problem.within_processor = longest(problem.within_processor);
  problem.between_processors = longest(problem.between_processors);
  return problem;
}

Growth growth_in(const Problem& problem, const Watch& watch, Nanoseconds cap, Limits limits) {
  limits.classes = std::min(limits.classes, most_classes);
  limits.enough = [](const ZoneGraph& graph) { return graph.over_cap() || graph.grows_on(); };
  const Machine machine(problem, watch);
  ZoneGraph graph(machine, cap, false, ZoneGraph::Merging::equal);
  const bool complete = graph.explore(limits);
  if (graph.relaxed()) return Growth::open;
  if (graph.over_cap() || graph.grows_on()) return Growth::counts;
  return complete && !graph.never_answered() ? Growth::ends : Growth::open;
}

}  // namespace

Growth growth(const Problem& problem, const Watch& watch, Nanoseconds cap, const Limits& limits) {
  // What counts and is greater than the limit breaks it, whatever the cap.
  const bool shown = growth_in(slowest(problem), watch, watch.limit, limits) == Growth::counts;
  return shown ? Growth::counts : growth_in(problem, watch, cap, limits);
}

}  // namespace pal::analyzer
