// Jog: moves the arm as long as a person holds a button.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

/// jog.pal.
std::unique_ptr<runtime::Skill> jog_skill();

}  // namespace pal::skills
