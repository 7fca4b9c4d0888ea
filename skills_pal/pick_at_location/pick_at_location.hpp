// Pick at Location: fetch a part.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

/// pick_at_location.pal.
std::unique_ptr<runtime::Skill> pick_at_location_skill();

}  // namespace pal::skills
