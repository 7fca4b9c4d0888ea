// What is known of a scene of the workcell: the program `workcell` tells it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "operations/check.hpp"
#include "programs/pal/session/built_skills.hpp"

namespace pal::program {

struct SceneCell {
  operations::Cell cell;    // without skills: those are read from their PAL
  std::string skills;       // the folder of their PAL
  std::string environment;  // the file of the cell's ENVIRONMENT
  std::vector<BuiltSkill> further;
};

/// Asks the `workcell` that lies beside this program, or that the PATH has. It also reads the files `built`: this
/// program does not run what others have compiled. `problem` says why there is no answer.
std::optional<SceneCell> cell_of_scene(const std::string& scene, const std::vector<std::string>& built,
                                       std::string& problem);

}  // namespace pal::program
