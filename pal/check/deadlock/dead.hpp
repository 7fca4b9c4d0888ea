// When a thread can never come to its end.
#pragma once

#include <functional>

#include "pal/check/deadlock/moves.hpp"

namespace pal::check::deadlock {

/// The thread waits for ever, or its end depends on blocks of its CONCURRENT that do. `never_moves` is called
/// for threads that wait or send.
bool dead(const Automata& automata, const Moves& moves, const State& state, std::size_t thread,
          const std::function<bool(std::size_t)>& never_moves);

}  // namespace pal::check::deadlock
