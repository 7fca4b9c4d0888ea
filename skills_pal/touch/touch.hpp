// Approach to touch, in both orders, with the activities written for it.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

/// touch.pal: waits for the robot's request and then reads the condition.
std::unique_ptr<runtime::Skill> touch_skill();

/// touch_read_first.pal: reads the condition and then waits for the request.
std::unique_ptr<runtime::Skill> touch_read_first_skill();

}  // namespace pal::skills
