// Changes of an environment that may mend a requirement, before any is tried.
#pragma once

#include <string>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// Changes that belong together, each as change() reads it: "PROCESSOR P4", "SM1.processor = P4".
using ChangeTexts = std::vector<std::string>;

/// In the order in which they ask least of an engineer: each thread before or behind the others of its
/// processor, each thread on another processor or on one more, each event or frame less often. `problem` is
/// of this environment.
std::vector<ChangeTexts> candidates_for(const Problem& problem, const pan::Environment& environment);

}  // namespace pal::analyzer
