// Skills that the compositional analysis refuses.
#pragma once

#include <functional>
#include <string>

#include "analyzer/compositional/causes/segment.hpp"

namespace pal::analyzer::compositional {

/// Why the analysis refuses a skill, as text for the user; empty if it does not. After `stop` has returned
/// true: that it was interrupted.
std::string refusal_of(const Problem& problem, const Segments& segments, const std::function<bool()>& stop);

}  // namespace pal::analyzer::compositional
