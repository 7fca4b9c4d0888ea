#include "analyzer/exact/zeno_run.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include "analyzer/load/cycle_ratio.hpp"
#include "analyzer/runs/concrete_run.hpp"
#include "analyzer/runs/snapshot.hpp"
#include "analyzer/runs/witness.hpp"

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

const Move& move_of(const ZoneGraph& graph, const Edge& edge) {
  const ZoneClass& from = graph.classes()[static_cast<std::size_t>(edge.from)];
  return graph.places()[static_cast<std::size_t>(from.state)].moves[static_cast<std::size_t>(edge.move)];
}

bool starts_at_once(const TimerChange& change) {
  return change.kind == TimerChange::Kind::start && change.range.best == 0;
}

/// The edges of the graph that a run may follow for ever at one instant. Each of their timers is started
/// again by one of them, and may be over at once: a device whose events are some time apart is none of these.
std::vector<int> edges_in_no_time(const ZoneGraph& graph) {
  std::vector<int> edges;
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const Edge& edge = graph.edges()[e];
    const Move& move = move_of(graph, edge);
    const ZoneClass& from = graph.classes()[static_cast<std::size_t>(edge.from)];
    if (!move.outcome.hurried && from.zone.at(move.variable, 0) <= 0) edges.push_back(static_cast<int>(e));
  }
  for (std::size_t before = edges.size() + 1; before != edges.size();) {
    before = edges.size();
    std::set<int> started;
    for (const int e : edges) {
      for (const TimerChange& change :
           move_of(graph, graph.edges()[static_cast<std::size_t>(e)]).outcome.changes) {
        if (starts_at_once(change)) started.insert(change.timer);
      }
    }
    std::erase_if(edges,
                  [&](int e) { return !started.contains(graph.edges()[static_cast<std::size_t>(e)].timer); });
  }
  return edges;
}

/// A way round along some of the edges, as indices of the graph's edges; empty: there is none.
std::vector<int> way_round(const ZoneGraph& graph, const std::vector<int>& edges) {
  std::vector<std::pair<int, int>> links;
  for (const int e : edges) {
    const Edge& edge = graph.edges()[static_cast<std::size_t>(e)];
    links.emplace_back(edge.from, edge.to);
  }
  const std::vector<Gain> gains(links.size(), 1);
  std::vector<int> way;
  for (int link : PositiveCycle(static_cast<int>(graph.classes().size()), links).find(gains))
    way.push_back(edges[static_cast<std::size_t>(link)]);
  return way;
}

/// Goes one way round in the concrete machine, again and again at one instant, until everything is as it was
/// a round before.
class Confirmation {
 public:
  Confirmation(const Machine& machine, const ZoneGraph& graph, const std::vector<int>& way)
      : machine_(machine), graph_(graph), way_(way) {}

  bool confirmed() {
    constexpr std::size_t most_beginnings = 16;
    for (std::size_t first = 0; first < std::min(way_.size(), most_beginnings); ++first) {
      if (from(first)) return true;
    }
    return false;
  }
  /// The edge that could not be followed, of the farthest try.
  int stopped_at() const { return stopped_at_; }

 private:
  const Edge& edge(std::size_t place) const {
    return graph_.edges()[static_cast<std::size_t>(way_[place % way_.size()])];
  }

  /// The timers that fire on the way before they are started on it. They are over when it begins.
  std::vector<std::pair<int, Nanoseconds>> due(std::size_t first) const {
    std::set<int> started;
    std::vector<std::pair<int, Nanoseconds>> over;
    for (std::size_t k = first; k < first + way_.size(); ++k) {
      if (!started.contains(edge(k).timer)) over.emplace_back(edge(k).timer, 0);
      for (const TimerChange& change : move_of(graph_, edge(k)).outcome.changes) {
        if (change.kind == TimerChange::Kind::start) started.insert(change.timer);
      }
      started.insert(edge(k).timer);
    }
    return over;
  }

  bool from(std::size_t first) {
    constexpr int most_rounds = 4;
    const auto script = script_to(machine_, graph_, edge(first).from, due(first));
    if (!script || !replay(machine_, *script)) return stop(first, first);
    ConcreteRun run(machine_, false);
    for (std::size_t k = 0; k < script->size(); ++k) {
      ScriptedChoices choices((*script)[k].choices);
      if (k == 0) {
        run.begin(choices);
      } else if (!run.fire((*script)[k].timer, (*script)[k].at, choices)) {
        return stop(first, first);
      }
    }
    for (int round = 0; round < most_rounds; ++round) {
      const Snapshot before(run);
      for (std::size_t k = first; k < first + way_.size(); ++k) {
        const ConcreteRun::Timer& timer = run.timers()[static_cast<std::size_t>(edge(k).timer)];
        const bool may_fire =
            timer.active && !timer.frozen && run.worked(edge(k).timer, run.now()) >= timer.range.best;
        ScriptedChoices choices(move_of(graph_, edge(k)).choices);
        if (!may_fire || !run.fire(edge(k).timer, run.now(), choices)) return stop(first, k);
      }
      if (Snapshot(run) == before) return true;
    }
    return stop(first, first);
  }

  bool stop(std::size_t first, std::size_t at) {
    if (stopped_at_ >= 0 && at - first <= farthest_) return false;
    farthest_ = at - first;
    stopped_at_ = way_[at % way_.size()];
    return false;
  }

  const Machine& machine_;
  const ZoneGraph& graph_;
  const std::vector<int>& way_;
  std::size_t farthest_ = 0;
  int stopped_at_ = -1;
};

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
  std::vector<int> edges = edges_in_no_time(graph);
  std::vector<int> way = way_round(graph, edges);
  if (way.empty()) return {.excluded = complete};
  // A way of classes need not be one of any run.
  constexpr int most_ways = 32;
  for (int n = 0; n < most_ways && !way.empty() && !(limits.stop && limits.stop()); ++n) {
    Confirmation confirmation(machine, graph, way);
    if (confirmation.confirmed()) return {.found = ZenoRun{cycle_statements(problem, graph, way)}};
    std::erase(edges, confirmation.stopped_at());
    way = way_round(graph, edges);
  }
  return {.suspected = true};
}

}  // namespace pal::analyzer
