// Scene files: what stands around the arm, which tool it has, where it starts (docs/workcell/scenes.md).
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/arm/kinematics.hpp"
#include "sim/arm/tool.hpp"

namespace pal::sim {

/// A scene that cannot be used: where, why, and what to do about it.
class SceneError : public std::runtime_error {
 public:
  SceneError(std::string place, std::string cause, std::string hint);

  const std::string& place() const { return place_; }  // file, or file:line:column
  const std::string& cause() const { return cause_; }
  const std::string& hint() const { return hint_; }

 private:
  std::string place_, cause_, hint_;
};

struct Scene {
  std::string name;
  std::filesystem::path file;
};

/// A scene by its name, or by the path of a file (anything with a '/' or ending in .scene or .xml). Names are
/// looked up in `folders`, in their order. Throws SceneError, with the names that there are as a hint.
Scene find_scene(const std::string& name_or_path, const std::vector<std::filesystem::path>& folders);

/// The names of the scenes in `folders`, sorted: every *.scene, and every *.xml that is not itself included
/// by another one there.
std::vector<Scene> list_scenes(const std::vector<std::filesystem::path>& folders);

/// What the scene says about itself in one line. Throws SceneError.
std::string describe_scene(const Scene& scene);

/// What the arm carries in it. Throws SceneError.
ToolKind tool_of(const Scene& scene);

}  // namespace pal::sim
