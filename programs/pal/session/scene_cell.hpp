// What is known of a scene of the workcell: the program `workcell` tells it.
#pragma once

#include <optional>
#include <string>

#include "operations/check.hpp"

namespace pal::program {

struct SceneCell {
  operations::Cell cell;    // without skills: those are read from their PAL
  std::string skills;       // the folder of their PAL
  std::string environment;  // the file of the cell's ENVIRONMENT
};

/// Asks the `workcell` that lies beside this program, or that the PATH has. `problem` says why there is no
/// answer.
std::optional<SceneCell> cell_of_scene(const std::string& scene, std::string& problem);

}  // namespace pal::program
