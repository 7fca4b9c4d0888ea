// The skills that are linked into the program.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/skill.hpp"

namespace pal::workcell {

struct KnownSkill {
  std::string name;
  std::function<std::unique_ptr<runtime::Skill>()> make;
};

/// Sorted by name.
std::vector<KnownSkill> linked_skills();

}  // namespace pal::workcell
