// The skills of skills_pal, loaded from the files that the build made of them, as workcell loads them.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "pal/runtime/plugin.hpp"

namespace pal::test {

/// All of them, in the order of their names.
const std::vector<const runtime::SkillPlugin*>& built_skills();

/// Throws std::runtime_error if there is none of this name.
const runtime::SkillPlugin& built_skill(std::string_view name);

std::unique_ptr<runtime::Skill> make_skill(std::string_view name);

}  // namespace pal::test
