#include "analyzer/load/load.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "analyzer/load/cycle_ratio.hpp"
#include "analyzer/load/grid.hpp"
#include "analyzer/load/share_bound.hpp"
#include "analyzer/load/unending.hpp"
#include "analyzer/load/unending_search.hpp"
#include "analyzer/load/work_graph.hpp"

namespace pal::analyzer {
namespace {

/// Grids that are larger are not tried before shares of the time.
constexpr std::size_t brief_grid = 20'000;

/// Points of a grid that is asked for a decision only, for each class that the skill has.
constexpr std::size_t points_a_class = 4;
constexpr std::size_t least_points = 1'000;

/// A slice's runs, shared by the processors that are in it.
struct Explored {
  Slice slice;
  std::unique_ptr<Grid> grid;
  std::size_t tried = 0;  // a limit with which it was not complete
  bool complete = false;
};

class Loads {
 public:
  Loads(const Machine& machine, const ZoneGraph& graph, const Limits& limits)
      : machine_(machine), graph_(graph), limits_(limits), recurrences_(recurrences(graph)) {}

  LoadBound of(ProcessorId processor) {
    LoadBound bound = idle();
    for (std::size_t r = 0; r < recurrences_.size(); ++r) bound = either(std::move(bound), in(r, processor));
    return bound;
  }

  const std::vector<Recurrence>& everywhere() const { return recurrences_; }

  /// In one recurrence, by a grid of a size in proportion to what the skill has.
  LoadBound on_grid(std::size_t r, ProcessorId processor) {
    Explored* explored = explored_of(r, processor);
    if (explored == nullptr) return idle();
    Limits brief = limits_;
    brief.classes = std::min(limits_.classes, points_a_class * graph_.classes().size() + least_points);
    return by_grid(*explored, r, processor, brief);
  }

 private:
  /// Null: nothing runs there again and again.
  Explored* explored_of(std::size_t r, ProcessorId processor) {
    Slice slice = slice_of(machine_, graph_, recurrences_[r], processor);
    if (std::find(slice.threads.begin(), slice.threads.end(), true) == slice.threads.end()) return nullptr;
    Explored& explored = explored_[{r, {slice.threads.begin(), slice.threads.end()}}];
    explored.slice = std::move(slice);
    return &explored;
  }

  static LoadBound idle() {
    LoadBound bound;
    bound.most = {0, 1};
    bound.proved = bound.exact = true;
    return bound;
  }

  /// Whether the run that is known attains what is proved. If it exceeded it the proof would be wrong, and
  /// count for nothing.
  static LoadBound compared(LoadBound bound) {
    if (greater(bound.shown, bound.most)) {
      bound.most = {1, 1};
      bound.proved = false;
    }
    bound.exact = !greater(bound.most, bound.shown);
    if (bound.exact) bound.most = bound.shown;
    bound.proved = bound.proved || bound.exact;
    return bound;
  }

  static void show(LoadBound& bound, LoadBound& other) {
    const bool more = greater(other.shown, bound.shown);
    if (!more && (bound.witness || greater(bound.shown, other.shown))) return;
    bound.shown = other.shown;
    bound.witness = std::move(other.witness);
  }

  /// Of runs that go on in one recurrence or the other.
  static LoadBound either(LoadBound bound, LoadBound other) {
    show(bound, other);
    if (greater(other.most, bound.most)) bound.most = other.most;
    bound.proved = bound.proved && other.proved;
    bound.states += other.states;
    return compared(std::move(bound));
  }

  /// Two of the same runs.
  static LoadBound both(LoadBound bound, LoadBound other) {
    show(bound, other);
    if (greater(bound.most, other.most)) bound.most = other.most;
    bound.proved = bound.proved || other.proved;
    bound.states += other.states;
    return compared(std::move(bound));
  }

  /// In one recurrence: a small grid, shares of the time with a run that is looked for, then a grid of any
  /// size.
  LoadBound in(std::size_t r, ProcessorId processor) {
    Explored* explored = explored_of(r, processor);
    if (explored == nullptr) return idle();
    Limits brief = limits_;
    brief.classes = std::min(limits_.classes, brief_grid);
    LoadBound bound = by_grid(*explored, r, processor, brief);
    if (!bound.exact) bound = by_shares(r, processor, std::move(bound));
    if (bound.exact || explored->complete) return bound;
    return both(std::move(bound), by_grid(*explored, r, processor, limits_));
  }

  LoadBound by_grid(Explored& explored, std::size_t r, ProcessorId processor, const Limits& limits) {
    if (!explored.complete && explored.tried < limits.classes) {
      explored.tried = limits.classes;
      explored.grid = std::make_unique<Grid>(machine_, explored.slice);
      Grid& made = *explored.grid;
      explored.complete =
          made.start(graph_, recurrences_[r], limits) && made.explore(limits) && !made.relaxed();
    }
    LoadBound bound;
    if (!explored.complete) return bound;
    const Grid& grid = *explored.grid;
    std::vector<WeightedEdge> edges;
    edges.reserve(grid.edges().size());
    for (const GridEdge& edge : grid.edges()) {
      const GridNode& from = grid.nodes()[static_cast<std::size_t>(edge.from)];
      const State& state = grid.places()[static_cast<std::size_t>(from.place)].state;
      const bool busy = state.running[processor] >= 0;
      edges.push_back({edge.from, edge.to, busy ? edge.time : 0, edge.time});
    }
    const auto nodes = static_cast<int>(grid.nodes().size());
    if (!can_add_up(nodes, edges)) return bound;
    const auto ratio = greatest_cycle_ratio(nodes, edges);
    bound.states = grid.nodes().size();
    bound.proved = true;
    bound.most = ratio ? Fraction{ratio->work, ratio->time} : Fraction{0, 1};
    if (bound.most.work > 0 && !grid.sporadic())
      bound.witness = unending_run(machine_, graph_, recurrences_[r], explored.slice, grid, ratio->edges);
    if (bound.witness) bound.shown = bound.most;
    return compared(std::move(bound));
  }

  LoadBound by_shares(std::size_t r, ProcessorId processor, LoadBound bound) const {
    const auto most = share_bound(work_graph(machine_, graph_, recurrences_[r], processor), {}, limits_.stop);
    if (most && greater(bound.most, *most)) bound.most = *most;
    bound.proved = bound.proved || most;
    if (bound.most.work == 0) return compared(std::move(bound));
    const auto attained = [&bound](const Fraction& load) { return !greater(bound.most, load); };
    auto run = search_unending(machine_, graph_, recurrences_[r], processor, attained, limits_.stop);
    if (run) {
      bound.shown = run->load;
      bound.witness = std::move(run->witness);
    }
    return compared(std::move(bound));
  }

  const Machine& machine_;
  const ZoneGraph& graph_;
  const Limits& limits_;
  std::vector<Recurrence> recurrences_;
  std::map<std::pair<std::size_t, std::vector<bool>>, Explored> explored_;
};

}  // namespace

bool ends_always(const Problem& problem, const ZoneGraph& graph) {
  const auto may_wait_for_ever = [](const Device& device) {
    const auto* event = std::get_if<pan::EventDevice>(&device.behaviour);
    return event != nullptr && event->sporadic;
  };
  if (std::any_of(problem.devices.begin(), problem.devices.end(), may_wait_for_ever)) return false;
  const auto goes_on = [](const Place& place) { return place.state.ended || !place.moves.empty(); };
  return std::all_of(graph.places().begin(), graph.places().end(), goes_on) && recurrences(graph).empty();
}

std::vector<LoadBound> load_bounds(const Machine& machine, const ZoneGraph& graph,
                                   const std::vector<ProcessorId>& processors, const Limits& limits) {
  Loads loads(machine, graph, limits);
  std::vector<LoadBound> bounds;
  for (ProcessorId processor : processors) bounds.push_back(loads.of(processor));
  return bounds;
}

LoadDecision decide_loads(const Machine& machine, const ZoneGraph& graph,
                          const std::vector<ProcessorId>& processors, const Fraction& limit,
                          const Limits& limits) {
  Loads loads(machine, graph, limits);
  const std::vector<Recurrence>& everywhere = loads.everywhere();
  const auto above = [&limit](const Fraction& load) { return greater(load, limit); };
  std::vector<std::pair<std::size_t, ProcessorId>> open;
  LoadDecision decision;
  decision.load = {0, 1};
  const auto proved = [&decision](const Fraction& most) {
    if (greater(most, decision.load)) decision.load = most;
  };
  for (std::size_t r = 0; r < everywhere.size(); ++r) {
    for (ProcessorId processor : processors) {
      const WorkGraph work = work_graph(machine, graph, everywhere[r], processor);
      if (const auto most = share_bound(work, limit, limits.stop)) {
        proved(*most);
      } else {
        open.emplace_back(r, processor);
      }
    }
  }
  for (const auto& [r, processor] : open) {
    auto run = search_unending(machine, graph, everywhere[r], processor, above, limits.stop);
    if (run && above(run->load)) return {VerdictState::fails, run->load, std::move(run->witness)};
  }
  bool all = true;
  for (const auto& [r, processor] : open) {
    LoadBound bound = loads.on_grid(r, processor);
    if (bound.witness && above(bound.shown))
      return {VerdictState::fails, bound.shown, std::move(bound.witness)};
    all = all && bound.proved && !above(bound.most);
    if (bound.proved) proved(bound.most);
  }
  if (all) decision.state = VerdictState::holds;
  return decision;
}

}  // namespace pal::analyzer
