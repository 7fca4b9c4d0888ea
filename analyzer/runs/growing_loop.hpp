// Values that grow with each turn of a loop: no bound is looked for where one run shows that there is none.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "analyzer/runs/witness.hpp"

namespace pal::analyzer {

/// A run with a stretch after which everything is as it was before, except that one and the same value has
/// grown. So the stretch can be gone through as often as one likes, and the value has no bound.
struct GrowingLoop {
  LoopId loop;              // that is gone round in the stretch; none: it is not one loop of one thread
  Nanoseconds stretch = 0;  // by so much the value grows each time
  Witness beyond;           // the stretch repeated until the value is greater than the limit
  /// A beginning of that run: up to where the value is measured for the third time, if it is measured in each
  /// turn.
  Witness first_turns;
};

/// Looks for one in single runs (no load, loss, busy period or least interval). It is claimed only after the
/// concrete machine went through the stretch, and the run beyond the limit was replayed. Nothing: that says
/// nothing.
std::optional<GrowingLoop> find_growing_loop(const Problem& problem, const Requirement& requirement,
                                             const std::function<bool()>& stop);

/// The phase in which the requirement keeps what renews the value, and leaves out `loop`: "DURING REPEAT OF
/// SPC( touched ) IN SM1". Empty: there is none, or the value grows in it, too.
std::string phase_without(const Problem& problem, const Requirement& requirement, LoopId loop,
                          const std::function<bool()>& stop);

}  // namespace pal::analyzer
