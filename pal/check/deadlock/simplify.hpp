// Removes from automata what makes no difference to their communication.
#pragma once

#include "pal/check/deadlock/automata.hpp"

namespace pal::check::deadlock {

/// Removes a test if the same follows whatever it finds. Then removes sets and latches of conditions that no
/// remaining test reads, and so on until nothing changes. Numbers the remaining conditions (Automata::bit).
void simplify(Automata& automata);

}  // namespace pal::check::deadlock
