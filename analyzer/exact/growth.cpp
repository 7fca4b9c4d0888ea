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

/// Of a value that counts: a run in which it is greater than the limit.
std::optional<Witness> shown_in(const Machine& machine, const ZoneGraph& graph, const Limits& limits) {
  const Findings& findings = graph.findings();
  if (findings.beyond) return witness_of(machine, graph, *findings.beyond, limits.stop);
  if (graph.stuck() >= 0) return stuck_witness(machine, graph, graph.stuck(), machine.watch().limit + 1);
  if (graph.round() >= 0) return grown_witness(machine, graph, graph.round(), limits.stop);
  return std::nullopt;
}

GrowthSearch growth_in(const Problem& problem, const Watch& watch, Nanoseconds cap, Limits limits) {
  limits.classes = std::min(limits.classes, most_classes);
  limits.enough = [](const ZoneGraph& graph) { return graph.over_cap() || graph.grows_on(); };
  const Machine machine(problem, watch);
  ZoneGraph graph(machine, cap, false, ZoneGraph::Merging::equal);
  const bool complete = graph.explore(limits);
  GrowthSearch made;
  made.statistics.states = graph.places().size();
  made.statistics.classes = graph.classes().size();
  if (graph.relaxed()) return made;
  if (graph.over_cap() || graph.grows_on()) {
    made.growth = Growth::counts;
    made.witness = shown_in(machine, graph, limits);
  } else if (complete && !graph.never_answered()) {
    made.growth = Growth::ends;
  }
  return made;
}

}  // namespace

GrowthSearch growth(const Problem& problem, const Watch& watch, Nanoseconds cap, const Limits& limits) {
  // What counts and is greater than the limit breaks it, whatever the cap.
  GrowthSearch found = growth_in(slowest(problem), watch, watch.limit, limits);
  if (found.growth == Growth::counts) return found;
  GrowthSearch further = growth_in(problem, watch, cap, limits);
  further.statistics += found.statistics;
  return further;
}

}  // namespace pal::analyzer
