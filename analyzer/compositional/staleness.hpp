// How long ago the value was set that a thread reads.
#pragma once

#include "analyzer/compositional/passes.hpp"

namespace pal::analyzer::compositional {

/// Greatest time since the set (or since time 0) whose value `reader` may read of `condition`.
Bound value_age(const View& view, int condition, int reader);

/// Whether `thread` goes on with its rounds for as long as `reader` does.
bool outlasts(const View& view, int thread, int reader);

}  // namespace pal::analyzer::compositional
