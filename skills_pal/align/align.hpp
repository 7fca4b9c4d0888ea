// Align: square to a flat surface.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

/// align.pal.
std::unique_ptr<runtime::Skill> align_skill();

}  // namespace pal::skills
