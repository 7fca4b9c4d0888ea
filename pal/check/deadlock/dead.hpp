// What it means that a thread never comes to its end.
#pragma once

#include <functional>

#include "pal/check/deadlock/moves.hpp"

namespace pal::checker::deadlock {

/// The thread waits for ever, or blocks of its CONCURRENT do on whose end its own depends. `never_moves` is
/// asked of threads that wait or send.
bool dead(const Automata& automata, const Moves& moves, const State& state, std::size_t thread,
          const std::function<bool(std::size_t)>& never_moves);

}  // namespace pal::checker::deadlock
