// Whether a skill can reach a state after which it never ends, and what becomes of its messages. Explores all
// its behaviour in as few orders as possible.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "pal/check/deadlock/independence.hpp"

namespace pal::check::deadlock {

struct Decision {
  bool complete = true;  // false: the limit was reached, and what was not found may be there
  bool blurred = false;  // what was found may not be there
  std::size_t states = 0;
  bool total = false;       // nothing moves any more
  bool partial = false;     // the first thread never goes on, whatever the others do
  std::vector<bool> put;    // by channel: some run puts a message there
  std::vector<bool> taken;  // by channel: some run takes one
  std::vector<bool>
      undelivered;  // by channel: there when some run completes; of those that `independence` observes
};

/// `stop`: asked again and again; true ends it as the limit does. Empty: never.
Decision decide(const Automata& automata, const Moves& moves, const Independence& independence,
                std::size_t most_states, const std::function<bool()>& stop);

}  // namespace pal::check::deadlock
