#include "skills_pal/registry.hpp"

#include <array>

#include "skills_pal/align/align.hpp"
#include "skills_pal/follow_edge/follow_edge.hpp"
#include "skills_pal/move_cartesian/move_cartesian.hpp"
#include "skills_pal/move_to_location/move_to_location.hpp"
#include "skills_pal/palletize/palletize.hpp"
#include "skills_pal/pick_at_location/pick_at_location.hpp"
#include "skills_pal/place_at_location/place_at_location.hpp"
#include "skills_pal/press/press.hpp"
#include "skills_pal/relative_move/relative_move.hpp"
#include "skills_pal/rub/rub.hpp"
#include "skills_pal/standoff/standoff.hpp"
#include "skills_pal/touch/touch.hpp"

namespace pal::skills {

namespace {

constexpr std::array<RegisteredSkill, 13> skills{{
    {"align", align_skill, "align/align.pal", "workcell.pal"},
    {"follow-edge", follow_edge_skill, "follow_edge/follow_edge.pal", "workcell.pal"},
    {"move-cartesian", move_cartesian_skill, "move_cartesian/move_cartesian.pal", "workcell.pal"},
    {"move-to-location", move_to_location_skill, "move_to_location/move_to_location.pal", "workcell.pal"},
    {"palletize", palletize_skill, "palletize/palletize.pal", "workcell.pal"},
    {"pick-at-location", pick_at_location_skill, "pick_at_location/pick_at_location.pal", "workcell.pal"},
    {"place-at-location", place_at_location_skill, "place_at_location/place_at_location.pal", "workcell.pal"},
    {"press", press_skill, "press/press.pal", "workcell.pal"},
    {"relative-move", relative_move_skill, "relative_move/relative_move.pal", "workcell.pal"},
    {"rub", rub_skill, "rub/rub.pal", "workcell.pal"},
    {"standoff", standoff_skill, "standoff/standoff.pal", "workcell.pal"},
    {"touch", touch_skill, "touch/touch.pal", "workcell.pal"},
    {"touch-read-first", touch_read_first_skill, "touch/touch_read_first.pal", "workcell.pal"},
}};

}  // namespace

std::span<const RegisteredSkill> registered_skills() {
  return skills;
}

std::unique_ptr<runtime::Skill> make_skill(std::string_view name) {
  for (const RegisteredSkill& skill : skills) {
    if (skill.name == name) return skill.make();
  }
  return nullptr;
}

}  // namespace pal::skills
