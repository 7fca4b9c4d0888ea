// Standoff: to a distance from the nearest surface.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

/// standoff.pal.
std::unique_ptr<runtime::Skill> standoff_skill();

}  // namespace pal::skills
