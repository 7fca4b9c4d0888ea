// Rub: slide along a surface with a force in a band.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

/// rub.pal.
std::unique_ptr<runtime::Skill> rub_skill();

}  // namespace pal::skills
