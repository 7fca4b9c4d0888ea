// Place at Location: put a part down.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

/// place_at_location.pal.
std::unique_ptr<runtime::Skill> place_at_location_skill();

}  // namespace pal::skills
