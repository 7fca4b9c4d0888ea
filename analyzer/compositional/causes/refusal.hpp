// Skills of which nothing is said.
#pragma once

#include <functional>
#include <string>

#include "analyzer/compositional/causes/segment.hpp"

namespace pal::analyzer::compositional {

/// Why nothing can be said of a skill: in words for the reader, or nothing. Once `stop` says so, that it was
/// interrupted.
std::string refusal_of(const Problem& problem, const Segments& segments, const std::function<bool()>& stop);

}  // namespace pal::analyzer::compositional
