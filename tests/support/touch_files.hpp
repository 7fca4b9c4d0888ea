// The files of the touch skill besides the skill itself.
#pragma once

#include <array>
#include <sstream>
#include <string>

#include "tests/support/project_file.hpp"

namespace pal::test {

/// From the project's root, each after those that it uses.
inline const std::array<std::string, 5> touch_modules{
    "skills_pal/modules/force_torque.pal", "skills_pal/modules/z_force.pal", "skills_pal/modules/alter.pal",
    "skills_pal/modules/retreat.pal", "skills_pal/touch/touch_modules.pal"};

/// All of them in one text, without USES.
inline std::string touch_modules_text() {
  std::string text;
  for (const std::string& path : touch_modules) {
    std::istringstream file(project_file(path));
    for (std::string line; std::getline(file, line);)
      if (!line.starts_with("USES")) text += line + "\n";
  }
  return text;
}

}  // namespace pal::test
