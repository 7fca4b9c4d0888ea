// Skills of which nothing is said.
#pragma once

#include <string>

#include "analyzer/compositional/causes/segment.hpp"

namespace pal::analyzer::compositional {

/// Why nothing can be said of a skill: in words for the reader, or nothing.
std::string refusal_of(const Problem& problem, const Segments& segments);

}  // namespace pal::analyzer::compositional
