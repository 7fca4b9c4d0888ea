// The times that activities have of themselves (docs/reference/language.md, modules).
#pragma once

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"

namespace pal::pan {

/// `environment` as `network` meets it: with the times that its activities declare. A time that the
/// environment gives counts instead, for the activity of that module or wherever it stands. Given such an
/// environment again, returns it as it is.
Environment with_times_of(const Network& network, Environment environment);

}  // namespace pal::pan
