// The effect of a firing on the timers, worked out once for each state.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analyzer/machine/machine.hpp"
#include "analyzer/zones/dbm.hpp"
#include "analyzer/zones/stop_token.hpp"

namespace pal::analyzer {

/// A class: what is known of a skill at one instant. It has a state, the possible values of the active timers
/// and the observers, and the way it was reached.
struct ZoneClass {
  int state = -1;  // a place
  Dbm zone;        // variables: 0, the state's timers, its observers
  int parent = -1;
  int move = -1;         // that led here: of the parent's place, or of the ways to begin
  bool relaxed = false;  // somewhere on the way the zone is larger than what can be
  int replaced_by = -1;
};

/// The firing of one timer of a place, with one combination of choices.
struct Move {
  /// A timer that is active afterwards.
  struct Kept {
    int timer = -1;
    int before = -1;      // its index among the timers before; -1: started now
    Range range;          // started now
    bool repaid = false;  // the action that ended gives its time back to it
    bool frozen = false;
  };
  /// The time that a timer can have left, where the time that it got back is not fixed.
  struct Left {
    std::size_t variable;
    Range range;
  };

  int timer = -1;  // -1: the start
  std::vector<std::uint8_t> choices;
  Outcome outcome;
  std::size_t variable = 0;  // of the timer
  Range cost;                // of the action that ended
  std::vector<Kept> timers;  // by number
  std::vector<Left> left;
  std::vector<int> numbers;
  std::vector<bool> frozen;
  int target = -1;  // the place that it leads to, once that is known; only if no observer passes the cap
};

/// A state of the machine with its active timers, in order, and where they lead.
struct Place {
  State state;
  std::vector<int> timers;
  std::vector<bool> frozen;
  std::vector<Move> moves;  // by timer
  bool moves_known = false;
};

/// All ways to begin. If they are too many the last one says so (Outcome::too_many). Some of them, if
/// `stop` was requested before all were known.
std::vector<Move> first_moves(const Machine& machine, StopToken& stop);
/// All firings that are possible at `place`, apart from times. If those of a timer are too many the last one
/// says so. Some of them, if `stop` was requested before all were known.
std::vector<Move> moves_from(const Machine& machine, const Place& place, StopToken& stop);

/// The way to begin, or the firing of the active timer number `k` of `place`, that `choices` make; nothing,
/// if that cannot fire. The caller knows what was chosen.
Move first_move(const Machine& machine, Choices& choices);
std::optional<Move> move_from(const Machine& machine, const Place& place, std::size_t k, Choices& choices);

/// The part of `zone` in which the timer of `variable` is the first to fire. False: there is none.
bool fire_first(Dbm& zone, std::size_t variable, const std::vector<bool>& frozen);

/// Where a variable comes from: one of another zone, moved by something in [low, high].
struct Source {
  std::size_t variable;
  Nanoseconds low;
  Nanoseconds high;
};
void derive(const Dbm& from, const std::vector<Source>& sources, Dbm& made);

/// The class after `move` from `from` (of which `fired` is the part where the move's timer fires first),
/// without place and ancestry. `made` and `sources` lend their memory. False: it is empty.
bool follow(const ZoneClass& from, const Dbm& fired, const Move& move, std::size_t timers_before,
            std::vector<Source>& sources, ZoneClass& made);

}  // namespace pal::analyzer
