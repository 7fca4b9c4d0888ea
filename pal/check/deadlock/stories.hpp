// The results of the search for deadlocks, as stories.
#pragma once

#include <vector>

#include "pal/check/deadlock/story.hpp"

namespace pal::check::deadlock {

/// The runs after which the skill stands still, or never ends, or completes with a command undelivered.
/// Empty: there are none. For a network without other errors.
std::vector<Story> stories(const pan::Network& network);

}  // namespace pal::check::deadlock
