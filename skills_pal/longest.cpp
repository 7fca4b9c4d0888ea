#include "skills_pal/longest.hpp"

#include <array>

namespace pal::skills {
namespace {

constexpr std::array table{
// clang-format off
#include "skills_pal/touch/longest.def"
#include "skills_pal/press/longest.def"
#include "skills_pal/rub/longest.def"
#include "skills_pal/align/longest.def"
#include "skills_pal/standoff/longest.def"
#include "skills_pal/follow_edge/longest.def"
#include "skills_pal/move_to_location/longest.def"
#include "skills_pal/move_cartesian/longest.def"
#include "skills_pal/relative_move/longest.def"
#include "skills_pal/pick_at_location/longest.def"
#include "skills_pal/place_at_location/longest.def"
#include "skills_pal/palletize/longest.def"
    // clang-format on
};

}  // namespace

std::span<const LongestTime> longest_times() {
  return table;
}

}  // namespace pal::skills
