// Inter-arrival times of sources.
#pragma once

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/times/times.hpp"

namespace pal::analyzer::compositional {

/// The latest instant at which a thread is idle for the first time, or the skill has ended.
Nanoseconds first_idle(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes,
                       ThreadId thread);

/// Latest arrival of a node at a wait or a fork.
Nanoseconds latest_arrival(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes, NodeId node,
                           StepId step);

/// Fills in no_overrun, longest_gap and first.
void find_inter_arrivals(const AnalysisContext& context, Times& times);

}  // namespace pal::analyzer::compositional
