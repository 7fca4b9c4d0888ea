#include "skills_pal/longest.hpp"

#include <array>

namespace pal::skills {
namespace {

// By ALTER a skill counts its steps, one each 28 ms (modules/approach.hpp): a distance over a speed. 2 s more
// are for opening the devices, for the last cycles, and for the steps that are no whole ones. A device that
// does not answer is given up within 6 s: VAL for 3.75 s, ALTER's first request for 1 s, the force-torque
// sensor for 1.2 s. So an error comes that much later at the most than the last other end.
//
// Press gives its force 30 s, and the time asked for, to stay in its band. Its lift-off ends within 60 mm, in
// 44 steps down to whole ones and 36 cycles of standing: 2.3 s.
//
// Align gives up in its 13th round. A round looks four times, 0.8 s each, and goes 45 mm aside at 1 mm a
// cycle. Twice it turns as far as 90 degrees, and goes along its axis as far as the range finder sees, 450
// mm.
//
// By VAL a joint motion through the whole of a joint's range takes 3.12 s at full speed (joint 2), a straight
// way through all that the arm reaches 2.5 m at 0.5 m/s. Gathering speed and coming to rest add less than 1.6
// s, and 0.5 s to a straight motion. Turning by a degree takes as long as 4.37 mm. A command costs 0.1 s on
// its line, the fingers less than 1 s. VAL is given up 110 s after a motion was commanded.
//
// Rub, standoff and follow-edge are missing: how long rub takes to land, how often standoff corrects itself
// and how long follow-edge aligns is not limited by their parameters.
constexpr std::array table{
    LongestTime{"touch", 0, "reach / approach-speed + 2"},
    LongestTime{"touch", 1, "2 * reach / approach-speed + 2"},
    LongestTime{"touch", 2, "2 * reach / approach-speed + 8"},
    LongestTime{"touch-read-first", 0, "reach / approach-speed + 2"},
    LongestTime{"touch-read-first", 1, "2 * reach / approach-speed + 2"},
    LongestTime{"touch-read-first", 2, "2 * reach / approach-speed + 8"},
    LongestTime{"press", 0, "search-distance / approach-speed + time + 32"},
    LongestTime{"press", 1, "2 * search-distance / approach-speed + 2"},
    LongestTime{"press", 2, "search-distance / approach-speed + time + 35"},
    LongestTime{"press", 3, "2 * search-distance / approach-speed + time + 41"},
    LongestTime{"align", 0, "386 + 66 / turn"},
    LongestTime{"align", 1, "386 + 66 / turn"},
    LongestTime{"align", 2, "392 + 66 / turn"},
    LongestTime{"move-to-location", 0, "(312 + 188 * straight) / speed + 4"},
    LongestTime{"move-to-location", 1, "4"},
    LongestTime{"move-to-location", 2, "120"},
    LongestTime{"move-cartesian", 0, "2500 / speed + 4"},
    LongestTime{"move-cartesian", 1, "4"},
    LongestTime{"move-cartesian", 2, "120"},
    LongestTime{"relative-move", 0,
                "max(norm(dx, dy, dz), 4.37 * (abs(rx) + abs(ry) + abs(rz))) / speed + 4"},
    LongestTime{"relative-move", 1, "4"},
    LongestTime{"relative-move", 2, "120"},
    LongestTime{"pick-at-location", 0, "(312 + 0.4 * approach) / speed + grip-delay + 8"},
    LongestTime{"pick-at-location", 1, "(312 + 0.4 * approach) / speed + grip-delay + 9"},
    LongestTime{"pick-at-location", 2, "(312 + 0.4 * approach) / speed + grip-delay + 125"},
    LongestTime{"pick-at-location", 3, "(312 + 0.4 * approach) / speed + grip-delay + 10"},
    LongestTime{"place-at-location", 0, "(312 + 0.4 * approach) / speed + 0.045 * approach + grip-delay + 8"},
    LongestTime{"place-at-location", 1,
                "(312 + 0.4 * approach) / speed + 0.045 * approach + grip-delay + 12"},
    LongestTime{"place-at-location", 2,
                "(312 + 0.4 * approach) / speed + 0.045 * approach + grip-delay + 130"},
    LongestTime{"palletize", 0, "(312 + 0.4 * approach) / speed + 0.045 * approach + grip-delay + 9"},
    LongestTime{"palletize", 1, "2"},
    LongestTime{"palletize", 2, "(312 + 0.4 * approach) / speed + 0.045 * approach + grip-delay + 130"},
    LongestTime{"palletize", 3, "(312 + 0.4 * approach) / speed + 0.045 * approach + grip-delay + 13"},
};

}  // namespace

std::span<const LongestTime> longest_times() {
  return table;
}

}  // namespace pal::skills
