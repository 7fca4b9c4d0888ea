// Leaves out of automata what cannot make a difference to their talk.
#pragma once

#include "pal/check/deadlock/automata.hpp"

namespace pal::checker::deadlock {

/// A test after which the same comes whatever it finds is passed over, then sets and latches of conditions
/// that no test is left to read, and so on until nothing changes. Numbers the conditions that remain
/// (Automata::bit).
void simplify(Automata& automata);

}  // namespace pal::checker::deadlock
