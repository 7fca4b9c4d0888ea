// Move to Location: to a location that was taught.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

/// move_to_location.pal.
std::unique_ptr<runtime::Skill> move_to_location_skill();

}  // namespace pal::skills
