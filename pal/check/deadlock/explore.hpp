// All runs of a skill, and what becomes of them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pal/check/deadlock/automata.hpp"
#include "pal/check/deadlock/moves.hpp"

namespace pal::frontend::deadlock {

/// A thread that never goes on, at a wait or a send.
struct Stuck {
  std::size_t thread = 0;
  std::size_t step = 0;
  bool never_asked = false;  // waits for the answer to a request that it has not sent, or not any more
};

/// A shortest run to where the skill can never complete because its method waits for ever.
struct DeadEnd {
  bool total = false;   // nothing moves any more; otherwise other modules go on
  bool timely = false;  // only if some wait gives up, or a device loses an answer, at the right time
  std::vector<Deed> run;
  std::vector<Stuck> stuck;
  std::size_t culprit = 0;  // index in `stuck`: of the skill method
};

struct Limits {
  std::size_t states = 200'000;
  std::size_t words = 24'000'000;  // states times words of each
};

struct Findings {
  bool complete = true;  // false: the limit was reached, and what was not found may be there
  std::size_t states = 0;
  std::optional<DeadEnd> total;
  std::optional<DeadEnd> partial;       // not if `total` says as much
  std::vector<pan::ChannelId> untaken;  // some run puts a message there, none ever takes one
};

/// Runs with the fewest timely moves come first, then the shortest. `reduced`: see reduction.hpp; without,
/// every order of moves is followed (for tests).
Findings explore(const Automata& automata, const Limits& limits = {}, bool reduced = true);

}  // namespace pal::frontend::deadlock
