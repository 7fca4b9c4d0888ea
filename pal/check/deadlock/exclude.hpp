// Whether a skill is without dead ends whatever values its conditions have: many orders in which these are
// set and tested are then one.
#pragma once

#include <functional>
#include <optional>

#include "pal/check/deadlock/decide.hpp"

namespace pal::checker::deadlock {

/// What is decided of the skill with its conditions unknown, if that has no dead end and takes every message
/// that is put, and some runs of the skill itself are seen to take each of them, too: then this is so of the
/// skill itself. Of the commands that are undelivered it may have fewer.
/// `withdrawn`: requests that are counted. `most_states` and `stop`: as for decide.
std::optional<Decision> exclude(const Automata& automata, int withdrawn, std::size_t most_states,
                                const std::function<bool()>& stop);

}  // namespace pal::checker::deadlock
