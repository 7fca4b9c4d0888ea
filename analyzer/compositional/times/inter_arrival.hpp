// How far apart occurrences of sources can be.
#pragma once

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/times/times.hpp"

namespace pal::analyzer::compositional {

/// When a thread is at home for the first time, or the skill has ended instead, at the latest.
Nanoseconds first_idle(const AnalysisContext& context, const std::vector<NodeTimes>& nodes, int thread);

/// Latest arrival at a wait or a fork that a node leads to.
Nanoseconds latest_arrival(const AnalysisContext& context, const std::vector<NodeTimes>& nodes, int node,
                           int step);

/// Fills in no_overrun, longest_gap and first.
void find_inter_arrivals(const AnalysisContext& context, Times& times);

}  // namespace pal::analyzer::compositional
