// The shortest run to a goal.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "pal/check/deadlock/independence.hpp"

namespace pal::check::deadlock {

/// Of two runs, the one with fewer unlucky moments is shorter. Then the one with fewer messages is, then the
/// one with fewer steps.
struct Length {
  std::uint32_t timely = 0;
  std::uint32_t talk = 0;
  std::uint32_t steps = 0;

  Length after(const Move& move) const {
    return {timely + (move.timely ? 1U : 0U), talk + (is_talk(move.action) ? 1U : 0U), steps + 1};
  }
  friend auto operator<=>(const Length&, const Length&) = default;
};

/// The goal: a state, or a move.
struct Goal {
  std::function<bool(const State&, const Enabled&)> state;  // empty: none
  std::function<bool(const State&, const Move&)> move;      // empty: none
  /// Threads such that every run from this state to the goal has a move of one of them. Empty: any threads
  /// will do, for goals in which nothing moves.
  std::function<Threads(const State&, const Enabled&)> needed;
};

struct Way {
  std::vector<Action> run;  // with the move that was looked for
  State state;              // where it leads
  Length length;
};

struct Found {
  std::optional<Way> way;
  bool complete = true;    // false: the limit was reached; what was not found may be there
  std::size_t states = 0;  // looked at
};

/// Searches in the order of length; `independence` must not absorb. `stop`: as for decide(), but it never
/// ends a search of few states.
Found search(const Moves& moves, const Independence& independence, std::size_t threads, const State& from,
             const Goal& goal, std::size_t most_states, const std::function<bool()>& stop);

/// The fewest threads that suffice. They contain all of `needed` if there are any; else one thread that can
/// move: the first that needs no other, if there is one. `first` is tried first.
Threads choose(const Independence& independence, const State& state, const Enabled& enabled,
               const Threads& needed, std::size_t first = 0);

}  // namespace pal::check::deadlock
