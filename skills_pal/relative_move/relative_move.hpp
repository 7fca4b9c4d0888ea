// Relative Move: by given distances and angles in the frame of the tool.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

/// relative_move.pal.
std::unique_ptr<runtime::Skill> relative_move_skill();

}  // namespace pal::skills
