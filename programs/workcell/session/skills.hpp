// The skills that are linked into the program.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pal/runtime/skill.hpp"

namespace pal::workcell {

struct KnownSkill {
  std::string name;
  std::function<std::unique_ptr<runtime::Skill>()> make;
  std::string pal_file{};  // in the folders of skills; empty: nothing is proved of it
  std::string environment_file{};
  std::map<int, std::string> longest{};  // formulas of its longest time in s, by completion code
};

/// Sorted by name.
std::vector<KnownSkill> linked_skills();

}  // namespace pal::workcell
