// Whether a skill has no dead ends whatever the values of its conditions. Then many orders of setting and
// testing them count as one.
#pragma once

#include <functional>
#include <optional>

#include "pal/check/deadlock/decide.hpp"

namespace pal::check::deadlock {

/// Decides the skill with its conditions unknown. The result holds for the skill itself on two conditions. It
/// has no dead end and takes every message that is put. And some runs of the skill itself are seen to take
/// each of them. It may have more undelivered commands than the skill itself. `withdrawn`: requests that are
/// counted. `most_states` and `stop`: as for decide.
std::optional<Decision> exclude(const Automata& automata, int withdrawn, std::size_t most_states,
                                const std::function<bool()>& stop);

}  // namespace pal::check::deadlock
