// From a scene's file to a MuJoCo model. Private to pal_sim.
#pragma once

#include <mujoco/mujoco.h>

#include <map>
#include <memory>
#include <string>

#include "sim/arm/machine.hpp"
#include "sim/arm/tool.hpp"
#include "sim/scene.hpp"

namespace pal::sim {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
using ModelPointer = std::unique_ptr<mjModel, DeleteModel>;

/// Where a scene says that the tool starts.
struct Start {
  Pose tool = Pose::Identity();
  Configuration configuration;
  std::string place;  // where the scene says so: file and line
};

/// What a scene's file comes to.
struct LoadedScene {
  ModelPointer model;  // never null
  std::map<std::string, Pose> locations;
  std::map<std::string, Eigen::Vector3d> sensors;  // where they stand, m
  std::map<std::string, int> lines;                // of a .scene's things, by their names
  Start start;
  ToolKind tool = ToolKind::pad;
  MachineOptions machine;
};

/// Loads a .scene file, or a scene in MJCF. Throws SceneError: with file and line where they are known.
LoadedScene load_scene(const Scene& scene);

}  // namespace pal::sim
