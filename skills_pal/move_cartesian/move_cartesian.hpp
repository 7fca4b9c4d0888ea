// Move Cartesian: in a straight line to a pose.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

/// move_cartesian.pal.
std::unique_ptr<runtime::Skill> move_cartesian_skill();

}  // namespace pal::skills
