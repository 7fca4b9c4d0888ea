// The machine's MJCF as part of the library, so that a scene file needs nothing beside it. Private to
// pal_sim.
#pragma once

#include <string_view>

namespace pal::sim::embedded {

extern const std::string_view puma560;         // sim/scenes/puma560.xml
extern const std::string_view cell;            // sim/scenes/cell.xml
extern const std::string_view gripper;         // sim/model/tools/gripper.xml, in place of the pad
extern const std::string_view gripper_drives;  // what belongs to it outside the arm
extern const std::string_view range_finder;    // sim/model/tools/range_finder.xml, in place of the pad

}  // namespace pal::sim::embedded
