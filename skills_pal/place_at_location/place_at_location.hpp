// Place at Location: put a part down.
#pragma once

#include <memory>

#include "runtime/skill.hpp"

namespace pal::skills {

/// place_at_location.pal.
std::unique_ptr<runtime::Skill> place_at_location_skill();

}  // namespace pal::skills
