#include "analyzer/exact/zeno_run.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "analyzer/load/cycle_ratio.hpp"

namespace pal::analyzer {
namespace {

/// Where a thread may go on to from a step at the same instant.
std::vector<StepId> at_once(const Step& step) {
  if (step.kind != Step::Kind::wait) return step.cost.worst == 0 ? step.next : std::vector<StepId>();
  std::vector<StepId> next;
  for (std::size_t i = 0; i < step.next.size(); ++i) {
    const bool takes = i < step.channels.size();
    if (takes ? step.cost.worst == 0 : step.within == 0 && step.give_up_cost.worst == 0)
      next.push_back(step.next[i]);
  }
  return next;
}

/// Whether the steps of some thread lead back to themselves in no time, if messages are there in time.
bool possible(const Problem& problem) {
  std::vector<std::pair<int, int>> links;
  for (const StepId s : problem.steps.ids()) {
    for (StepId next : at_once(problem.steps[s])) links.emplace_back(s.value, next.value);
  }
  const std::vector<Gain> gains(links.size(), 1);
  return !PositiveCycle(static_cast<int>(problem.steps.size()), links).find(gains).empty();
}

/// Firings on the way round that can take no time, as indices of the graph's edges.
std::vector<int> way_round(const ZoneGraph& graph) {
  std::vector<std::pair<int, int>> links;
  std::vector<int> edges;
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const Edge& edge = graph.edges()[e];
    const ZoneClass& from = graph.classes()[static_cast<std::size_t>(edge.from)];
    const Place& place = graph.places()[static_cast<std::size_t>(from.state)];
    const Move& move = place.moves[static_cast<std::size_t>(edge.move)];
    if (move.outcome.hurried || from.zone.at(move.variable, 0) > 0) continue;
    links.emplace_back(edge.from, edge.to);
    edges.push_back(static_cast<int>(e));
  }
  const std::vector<Gain> gains(links.size(), 1);
  std::vector<int> way;
  for (int link : PositiveCycle(static_cast<int>(graph.classes().size()), links).find(gains))
    way.push_back(edges[static_cast<std::size_t>(link)]);
  return way;
}

std::vector<StatementId> cycle_statements(const Problem& problem, const ZoneGraph& graph,
                                          const std::vector<int>& way) {
  std::set<StatementId> found;
  for (int e : way) {
    const Edge& edge = graph.edges()[static_cast<std::size_t>(e)];
    const ThreadId thread = ThreadId::of(edge.timer);
    if (!problem.threads.contains(thread)) continue;
    const ZoneClass& from = graph.classes()[static_cast<std::size_t>(edge.from)];
    const State& state = graph.places()[static_cast<std::size_t>(from.state)].state;
    const StepId step = state.threads[thread].at();
    const StatementId statement = problem.steps[step].statement;
    if (statement.valid()) found.insert(statement);
  }
  std::vector<StatementId> ordered(found.begin(), found.end());
  std::stable_sort(ordered.begin(), ordered.end(), [&problem](StatementId a, StatementId b) {
    const Statement& one = problem.statements[a];
    const Statement& other = problem.statements[b];
    return std::tie(one.file, one.line) < std::tie(other.file, other.line);
  });
  return ordered;
}

}  // namespace

ZenoSearch find_zeno_run(const Problem& problem, const Limits& limits) {
  if (!possible(problem)) return {.excluded = true};
  if (!fits_exploration(problem)) return {};
  const Watch nothing;
  const Machine machine(problem, nothing);
  ZoneGraph graph(machine, 0, true);
  const bool complete = graph.explore(limits);
  const std::vector<int> way = way_round(graph);
  if (way.empty()) return {.excluded = complete};
  return {.found = ZenoRun{cycle_statements(problem, graph, way)}};
}

}  // namespace pal::analyzer
