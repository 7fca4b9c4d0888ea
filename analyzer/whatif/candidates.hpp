// Changes of an environment that may mend a requirement, before any is tried.
#pragma once

#include <string>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer::whatif {

/// Changes that belong together, each as change() reads it: "PROCESSOR P4", "SM1.processor = P4".
using ChangeTexts = std::vector<std::string>;

/// The candidates, those that ask least of an engineer first. Each thread goes before or behind the others of
/// its processor. Each thread goes to another processor, or to one more. Each event or frame comes less
/// often. `problem` is of this environment.
std::vector<ChangeTexts> candidates_for(const Problem& problem, const pan::Environment& environment);

}  // namespace pal::analyzer::whatif
