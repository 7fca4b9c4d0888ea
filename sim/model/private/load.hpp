// Reading MJCF. Private to pal_sim.
#pragma once

#include <mujoco/mujoco.h>

#include "sim/scene.hpp"

namespace pal::sim {

/// Loads the scene's file. Throws SceneError with the place that MuJoCo names. The caller owns the model.
mjModel* load_model(const Scene& scene);

/// Where a scene says that the tool starts.
struct Start {
  Pose tool = Pose::Identity();
  Configuration configuration;
};

/// Reads the scene's custom elements "start" and "configuration". Throws SceneError.
Start read_start(const mjModel& model, const Scene& scene);

}  // namespace pal::sim
