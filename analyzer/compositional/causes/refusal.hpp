// Skills that the compositional analysis refuses.
#pragma once

#include <functional>

#include "analyzer/compositional/causes/segment.hpp"
#include "analyzer/compositional/causes/withheld.hpp"

namespace pal::analyzer::compositional {

/// Why the analysis refuses a skill; empty if it does not. After `stop` has returned true: that it was
/// interrupted.
Why refusal_of(const Problem& problem, const Segments& segments, const std::function<bool()>& stop,
               const SetAside& set_aside = {});

}  // namespace pal::analyzer::compositional
