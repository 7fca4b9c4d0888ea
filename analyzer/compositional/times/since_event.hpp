// When everything that an event causes is done, counted from the event itself.
#pragma once

#include "analyzer/compositional/times/interference.hpp"

namespace pal::analyzer::compositional {

/// For nodes that an event triggers: the sum along the path from the event. Each segment counts from its own
/// release. Segments that share a window (joint_chain()) count together from the release of the first. The
/// result is at most the time from the event's nominal instant, which is earlier. For all other nodes:
/// `times.nodes`.
Table<NodeId, NodeTimes> since_events(const AnalysisContext& context, const Times& times,
                                      const Interference& interference);

}  // namespace pal::analyzer::compositional
