// Palletize: put a part at the next place of a pallet.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

/// palletize.pal.
std::unique_ptr<runtime::Skill> palletize_skill();

}  // namespace pal::skills
