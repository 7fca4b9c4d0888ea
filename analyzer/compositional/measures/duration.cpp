// How long a skill runs.
#include <algorithm>

#include "analyzer/compositional/measures/job_view.hpp"

namespace pal::analyzer::compositional {

/// A completion that a module comes to from the start, or with the first occurrence of something that comes
/// at bounded inter-arrival times.
Bound duration_bound(const View& view, const Requirement& requirement) {
  Sum longest;
  bool any = false;
  for (const NodeId i : view.forest.nodes.ids()) {
    const NodeId n = i;
    const Node& node = view.forest.nodes[i];
    const Source& source = view.forest.sources[node.source];
    for (const Segment::Passed& passed : view.forest.segment_of(node).steps) {
      const Step& step = view.problem.steps[passed.step];
      const bool completes = step.kind == Step::Kind::complete && step.code == requirement.code;
      const bool fails = may_match_nothing(step) && requirement.code == view.problem.error_code;
      if (!completes && !fails) continue;
      any = true;
      const bool at_start = source.kind == Source::Kind::start;
      const bool known = at_start || !view.withholds(Withheld::completed_in_some_job);
      longest = greater(longest, known ? latest(view, n, passed.step) : Sum::unbounded());
    }
  }
  if (!any) return no_bound(why(Withheld::never_completed));
  return {longest, why(Withheld::completed_in_some_job)};
}

}  // namespace pal::analyzer::compositional
