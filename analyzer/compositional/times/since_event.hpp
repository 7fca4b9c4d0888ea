// When everything that an event causes is done, counted from the event itself.
#pragma once

#include "analyzer/compositional/times/interference.hpp"

namespace pal::analyzer::compositional {

/// Of nodes that an event with jitter brings about: the ways from the event, each segment no longer than it
/// takes from its own release; at most the times from the event's nominal instant, which comes first. Of all
/// others: `times.nodes`, which are the same.
std::vector<NodeTimes> since_events(const AnalysisContext& context, const Times& times,
                                    const Interference& interference);

}  // namespace pal::analyzer::compositional
