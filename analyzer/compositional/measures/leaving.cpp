// Skills that end when a block leaves its loop.
#include <algorithm>

#include "analyzer/compositional/measures/job_view.hpp"

namespace pal::analyzer::compositional {
namespace {

using Measure = Requirement::Measure;

/// The next event but one must not come while the skill is ending: the first may find no idle thread. The
/// thread that was to take it is still at work with the one before until it would have taken it.
bool over_before_next(const View& view, DeviceId device, const Sum& over) {
  const auto in_time = [&](const Source& source, NodeId root) {
    const Nanoseconds taken = view.times.nodes[root].effects.front();
    return plus(over.value(), taken) < source.period;
  };
  return std::any_of(view.forest.sources.begin(), view.forest.sources.end(), [&](const Source& source) {
    return source.kind == Source::Kind::event && source.device == device &&
           std::all_of(source.roots.begin(), source.roots.end(),
                       [&](NodeId root) { return in_time(source, root); });
  });
}

}  // namespace

Bound until_left(const View& always, const Endurance& endurance, const Requirement& requirement,
                 const std::function<Bound(const View&, const Requirement&)>& bound_of) {
  const View steady{always.problem,
                    always.forest,
                    always.behaviours,
                    always.times,
                    endurance.steady.reliable,
                    endurance.steady.lively,
                    endurance.steady.begun,
                    true};
  const Bound strict = bound_of(always, requirement);
  const bool of_events = requirement.measure == Measure::response || requirement.measure == Measure::loss;
  if (endurance.leavers.empty() || !of_events ||
      !over_before_next(always, requirement.device, endurance.over))
    return strict;
  Bound bound = bound_of(steady, requirement);
  if (requirement.measure == Measure::response) bound.sum = bound.sum + endurance.over;
  return bound.known() ? bound : strict;
}

}  // namespace pal::analyzer::compositional
