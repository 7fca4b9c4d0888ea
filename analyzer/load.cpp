#include "analyzer/load.hpp"

#include <map>
#include <memory>

#include "analyzer/cycle_ratio.hpp"
#include "analyzer/grid.hpp"
#include "analyzer/unending.hpp"

namespace pal::analyzer {
namespace {

__extension__ using Wide = __int128;

/// A slice's runs, shared by the processors that are in it.
struct Explored {
  Slice slice;
  std::unique_ptr<Grid> grid;
  bool complete = false;
};

class Loads {
 public:
  Loads(const Machine& machine, const ZoneGraph& graph, const Limits& limits)
      : machine_(machine), graph_(graph), limits_(limits), recurrences_(recurrences(graph)) {}

  LoadBound of(int processor) {
    LoadBound bound;
    bound.most = {0, 1};
    bound.proved = bound.exact = true;
    for (std::size_t r = 0; r < recurrences_.size(); ++r) {
      const Explored* explored = explore(r, processor);
      if (explored == nullptr) continue;
      if (!explored->complete) return {};
      consider(*explored, recurrences_[r], processor, bound);
    }
    return bound;
  }

 private:
  const Explored* explore(std::size_t r, int processor) {
    Slice slice = slice_of(machine_, graph_, recurrences_[r], processor);
    bool any = false;
    for (bool thread : slice.threads) any = any || thread;
    if (!any) return nullptr;
    auto& known = explored_[{r, slice.threads}];
    if (known) return known.get();
    known = std::make_unique<Explored>();
    known->slice = std::move(slice);
    known->grid = std::make_unique<Grid>(machine_, known->slice);
    known->complete = known->grid->start(graph_, recurrences_[r], limits_) && known->grid->explore(limits_) &&
                      !known->grid->relaxed();
    return known.get();
  }

  void consider(const Explored& explored, const Recurrence& recurrence, int processor, LoadBound& bound) {
    const Grid& grid = *explored.grid;
    bound.states += grid.nodes().size();
    std::vector<WeightedEdge> edges;
    edges.reserve(grid.edges().size());
    for (const GridEdge& edge : grid.edges()) {
      const GridNode& from = grid.nodes()[static_cast<std::size_t>(edge.from)];
      const State& state = grid.places()[static_cast<std::size_t>(from.place)].state;
      const bool busy = state.running[static_cast<std::size_t>(processor)] >= 0;
      edges.push_back({edge.from, edge.to, busy ? edge.time : 0, edge.time});
    }
    const auto ratio = greatest_cycle_ratio(static_cast<int>(grid.nodes().size()), edges);
    if (!ratio) return;
    const Fraction most{ratio->work, ratio->time};
    // Of two recurrences with the same load one may be shown by a run and the other not.
    if (greater(bound.most, most) || (!greater(most, bound.most) && bound.exact)) return;
    bound.most = most;
    bound.witness.reset();
    if (!grid.sporadic())
      bound.witness = unending_run(machine_, graph_, recurrence, explored.slice, grid, ratio->edges);
    bound.exact = bound.witness.has_value();
  }

  const Machine& machine_;
  const ZoneGraph& graph_;
  const Limits& limits_;
  std::vector<Recurrence> recurrences_;
  std::map<std::pair<std::size_t, std::vector<bool>>, std::unique_ptr<Explored>> explored_;
};

}  // namespace

bool greater(const Fraction& a, const Fraction& b) {
  return static_cast<Wide>(a.work) * b.time > static_cast<Wide>(b.work) * a.time;
}

Nanoseconds per_second(const Fraction& fraction) {
  const Wide scaled = static_cast<Wide>(fraction.work) * 1'000'000'000;
  return static_cast<Nanoseconds>((scaled + fraction.time - 1) / fraction.time);
}

std::vector<LoadBound> load_bounds(const Machine& machine, const ZoneGraph& graph,
                                   const std::vector<int>& processors, const Limits& limits) {
  Loads loads(machine, graph, limits);
  std::vector<LoadBound> bounds;
  for (int processor : processors) bounds.push_back(loads.of(processor));
  return bounds;
}

}  // namespace pal::analyzer
