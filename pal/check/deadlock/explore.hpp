// All runs of a skill, and what becomes of them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pal/check/deadlock/automata.hpp"
#include "pal/check/deadlock/moves.hpp"

namespace pal::check::deadlock {

/// A thread that never goes on, at a wait or a send.
struct Stuck {
  std::size_t thread = 0;
  std::size_t step = 0;
  bool never_asked = false;  // waits for the answer to a request that it has not sent, or not any more
};

/// A shortest run (search.hpp defines its length) to a state in which the skill can never complete, because
/// its method waits for ever.
struct DeadEnd {
  bool total = false;   // nothing moves any more; otherwise other modules go on
  bool timely = false;  // only if some wait gives up, or a device loses an answer, at the right time
  std::vector<Action> run;
  std::size_t decided = 0;  // from this action on it can never end; what follows only brings others to a stop
  std::vector<Stuck> stuck;
  std::size_t culprit = 0;  // index in `stuck`: of the skill method
};

/// A command that is still in its slot when the skill completes, with a shortest run to there.
struct Undelivered {
  pan::ChannelId channel;
  bool timely = false;
  std::vector<Action> run;  // the last one completes the skill
};

struct Limits {
  std::size_t states = 200'000;
  std::size_t words = 24'000'000;         // states times words of each
  int withdrawn = Moves::most_withdrawn;  // requests, yet to be answered, that are counted exactly
  std::size_t at_first = 1'000;           // states, before it is tried without the values of conditions
  std::size_t shared = 1'000'000;         // states, in all searches of one kind together
  std::function<bool()> stop;             // asked again and again; true ends the search. Empty: never
};

struct Findings {
  bool complete = true;  // false: a limit was reached, and what was not found may be there
  bool overflowed =
      false;  // … because more requests than can be counted are open, or withdrawn and not yet answered
  bool stopped = false;  // … because it was time to end
  bool blurred = false;  // more requests were withdrawn than are counted; what is found is real all the same
  bool without_values = false;  // whatever values the conditions have, it is the same
  std::size_t states = 0;
  std::optional<DeadEnd> total;
  std::optional<DeadEnd> partial;       // not if `total` says as much
  std::vector<pan::ChannelId> untaken;  // some run puts a message there, none ever takes one
  std::vector<Undelivered> undelivered;
};

Findings explore(const Automata& automata, const Limits& limits = {});

}  // namespace pal::check::deadlock
