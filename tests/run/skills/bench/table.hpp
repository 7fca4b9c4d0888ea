// The table of figures that the skills are to reach.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tests/run/skills/support/proved_bounds.hpp"

namespace pal::test {

struct Figure {
  std::string skill;
  std::string what;      // "5 N on 20 N/mm, seeds 1 to 3"
  std::string to_reach;  // "rms <= 0.1 N"; "reported": only shown
  std::string measured;  // "rms 0.04 N"
  bool reached = true;
  double of_bound = 0;  // worst observed over proved, of any requirement
  AlterCycles alter{};
};

/// What was measured of the runs that `bounds` observed.
inline Figure observed(Figure figure, const ProvedBounds& bounds) {
  figure.of_bound = bounds.greatest_part();
  figure.alter = bounds.alter();
  return figure;
}

/// Markdown. True if all were reached, nothing was measured beyond what was proved, and no ALTER cycle was
/// missed.
bool write(const std::vector<Figure>& figures, std::ostream& out);

// One function a skill; each runs its scenes and prints nothing.
std::vector<Figure> measure_touch();
std::vector<Figure> measure_press();
std::vector<Figure> measure_rub();
std::vector<Figure> measure_standoff();
std::vector<Figure> measure_align();
std::vector<Figure> measure_follow_edge();
std::vector<Figure> measure_moves();
std::vector<Figure> measure_transfers();
std::vector<Figure> measure_palletize();

}  // namespace pal::test
