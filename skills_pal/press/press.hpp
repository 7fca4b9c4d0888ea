// Press: search a surface, hold a force on it.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

/// press.pal.
std::unique_ptr<runtime::Skill> press_skill();

}  // namespace pal::skills
