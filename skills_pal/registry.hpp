// The skills that the workcell can run, by name.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

struct RegisteredSkill {
  std::string_view name;  // as in PAL
  std::unique_ptr<runtime::Skill> (*make)();
  std::string_view pal_file;  // in this folder, and where it is installed
  std::string_view environment_file;
};

/// All of them, in the order of their names.
std::span<const RegisteredSkill> registered_skills();

/// A new one, or null if there is none of that name.
std::unique_ptr<runtime::Skill> make_skill(std::string_view name);

}  // namespace pal::skills
