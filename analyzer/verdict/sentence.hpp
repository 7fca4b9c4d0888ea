// The explanation of a bound as one sentence; the parts come from `story`.
#pragma once

#include <string>
#include <vector>

#include "analyzer/verdict/verdict.hpp"

namespace pal::analyzer {

/// A verdict in words. `verdict.witness` and `verdict.reasons` must be set.
Told explanation(const Problem& problem, const Requirement& requirement, const Verdict& verdict);

/// Why no run measures anything. `passed`: what is watched does happen.
std::string nothing_measured(const Requirement& requirement, bool passed);

/// A story that is short enough to be read. Of a long one, the first and the last pieces. Between them stands
/// one piece that says how many are left out, and takes as long as they do.
std::vector<Reason> abridged(const std::vector<Reason>& reasons);

/// "27.95 ms", exact.
std::string milliseconds(Nanoseconds time);

}  // namespace pal::analyzer
