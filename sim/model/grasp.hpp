// Friction between the gripper's pads and what they hold. Private to pal_sim.
#pragma once

#include <vector>

#include "sim/model/mujoco_physics.hpp"

namespace pal::sim {

/// MuJoCo asks of friction that the two bodies be accelerated alike along the surface, J·q̈ = a. It leaves
/// out J̇·q̇, the acceleration of a moving point while its joints turn evenly. A part in a hand that goes
/// along a curve therefore slips outwards, 0.1 mm in a transfer. This adds the term to what the solver aims
/// at, for the contacts of the gripper's pads; to be called between mj_step1 and mj_step2.
class GraspFriction {
 public:
  void correct(const mjModel& model, mjData& data, const ModelIndex& index);

 private:
  std::vector<mjtNum> acceleration_;  // of each body at even joint speeds, as MuJoCo's cacc
};

}  // namespace pal::sim
