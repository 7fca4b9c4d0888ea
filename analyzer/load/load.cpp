#include "analyzer/load/load.hpp"

#include <algorithm>
#include <utility>

#include "analyzer/load/recurrence.hpp"
#include "analyzer/load/share_bound.hpp"
#include "analyzer/load/unending_search.hpp"
#include "analyzer/load/work_graph.hpp"

namespace pal::analyzer {
namespace {

/// No load at all.
LoadBound idle() {
  LoadBound bound;
  bound.most = {0, 1};
  bound.proved = bound.exact = true;
  return bound;
}

/// Whether the run that is known attains what is proved. If it exceeded it the proof would be wrong, and
/// count for nothing.
LoadBound compared(LoadBound bound) {
  if (greater(bound.shown, bound.most)) {
    bound.most = {1, 1};
    bound.proved = false;
  }
  bound.exact = !greater(bound.most, bound.shown);
  if (bound.exact) bound.most = bound.shown;
  bound.proved = bound.proved || bound.exact;
  return bound;
}

/// Of runs that go on in one recurrence or the other.
LoadBound either(LoadBound bound, LoadBound other) {
  if (greater(other.shown, bound.shown) || (!bound.witness && !greater(bound.shown, other.shown))) {
    bound.shown = other.shown;
    bound.witness = std::move(other.witness);
  }
  if (greater(other.most, bound.most)) bound.most = other.most;
  bound.proved = bound.proved && other.proved;
  return compared(std::move(bound));
}

/// In one recurrence: by shares of the time, and a run that is looked for.
LoadBound in(const Machine& machine, const ZoneGraph& graph, const Recurrence& recurrence, ProcessorId processor,
             const std::function<bool()>& stop) {
  LoadBound bound;
  const auto most = share_bound(work_graph(machine, graph, recurrence, processor), {}, stop);
  if (most) bound.most = *most;
  bound.proved = most.has_value();
  if (bound.most.work == 0) return compared(std::move(bound));
  const auto attained = [&bound](const Fraction& load) { return !greater(bound.most, load); };
  auto run = search_unending(machine, graph, recurrence, processor, attained, stop);
  if (run) {
    bound.shown = run->load;
    bound.witness = std::move(run->witness);
  }
  return compared(std::move(bound));
}

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
                                   const std::vector<ProcessorId>& processors, const std::function<bool()>& stop) {
  const std::vector<Recurrence> everywhere = recurrences(graph);
  std::vector<LoadBound> bounds;
  for (const ProcessorId processor : processors) {
    LoadBound bound = idle();
    for (const Recurrence& recurrence : everywhere)
      bound = either(std::move(bound), in(machine, graph, recurrence, processor, stop));
    bounds.push_back(std::move(bound));
  }
  return bounds;
}

LoadDecision decide_loads(const Machine& machine, const ZoneGraph& graph, const std::vector<ProcessorId>& processors,
                          const Fraction& limit, const std::function<bool()>& stop) {
  const auto above = [&limit](const Fraction& load) { return greater(load, limit); };
  std::vector<std::pair<const Recurrence*, ProcessorId>> open;
  LoadDecision decision;
  decision.load = {0, 1};
  const std::vector<Recurrence> everywhere = recurrences(graph);
  for (const Recurrence& recurrence : everywhere) {
    for (const ProcessorId processor : processors) {
      const WorkGraph work = work_graph(machine, graph, recurrence, processor);
      const auto most = share_bound(work, limit, stop);
      if (!most) open.emplace_back(&recurrence, processor);
      if (most && greater(*most, decision.load)) decision.load = *most;
    }
  }
  for (const auto& [recurrence, processor] : open) {
    auto run = search_unending(machine, graph, *recurrence, processor, above, stop);
    if (run && above(run->load)) return {VerdictState::fails, run->load, std::move(run->witness)};
  }
  if (open.empty()) decision.state = VerdictState::holds;
  return decision;
}

}  // namespace pal::analyzer
