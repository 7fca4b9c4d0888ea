// What the search for deadlocks finds of a skill, told.
#pragma once

#include <vector>

#include "pal/check/deadlock/story.hpp"

namespace pal::checker::deadlock {

/// The runs to where the skill stands still, or never ends, or completes with a command undelivered; none of
/// that: empty. For a network without other errors.
std::vector<Story> stories(const pan::Network& network);

}  // namespace pal::checker::deadlock
