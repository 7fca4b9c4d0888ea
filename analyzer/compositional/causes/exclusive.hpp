// What comes at most once in each round.
#pragma once

#include <vector>

#include "analyzer/compositional/causes/analysis_context.hpp"

namespace pal::analyzer::compositional {

/// The effect of a step in a node.
struct StepEffect {
  int node = -1;
  int step = -1;
};

/// Whether all stand in one round of one thread, and no run of it passes two of them. So an occurrence of the
/// round's source brings about one of them at most.
bool are_exclusive(const AnalysisContext& context, const std::vector<StepEffect>& occurrences);

}  // namespace pal::analyzer::compositional
