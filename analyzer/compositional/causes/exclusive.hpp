// Step effects that exclude one another within a job.
#pragma once

#include <vector>

#include "analyzer/compositional/causes/analysis_context.hpp"

namespace pal::analyzer::compositional {

/// The effect of a step in a node.
struct StepEffect {
  NodeId node{};
  StepId step{};
};

/// Whether all belong to one job of one thread and no run of the job has two of them. So an occurrence of the
/// job's source has at most one of them.
bool are_exclusive(const AnalysisContext& context, const std::vector<StepEffect>& occurrences);

}  // namespace pal::analyzer::compositional
