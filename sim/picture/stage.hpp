// A copy of the model for pictures. Private to pal_sim.
#pragma once

#include <array>
#include <memory>

#include "sim/model/mujoco_physics.hpp"
#include "sim/picture/framing.hpp"
#include "sim/picture/snapshot.hpp"

namespace pal::sim {

/// Owns its model and its state, so drawing never touches the physics, on whatever thread.
class Stage {
 public:
  explicit Stage(const mjModel& model);

  /// Puts every body where the snapshot has it.
  void show(const Snapshot& snapshot);

  mjModel& model() { return *model_; }
  const mjModel& model() const { return *model_; }
  mjData& data() { return *data_; }
  const mjData& data() const { return *data_; }
  /// In the world's frame.
  Eigen::Vector3d tip() const;
  /// How the tool's tip is turned in the world.
  Eigen::Matrix3d tip_turn() const;
  ToolKind tool() const { return tool_; }
  /// A place of frame 0 in the world.
  Eigen::Vector3d in_world(const Eigen::Vector3d& place) const;
  /// Out of the tool; length 1.
  Eigen::Vector3d pointing() const;
  Eigen::Vector3d base() const;  // the shoulder: frame 0
  /// The body is the arm's: its base or anything that hangs on it.
  bool of_arm(int body) const;
  /// The body is beyond the flange: sensors, tool, gripper.
  bool of_tool(int body) const;

 private:
  bool hangs_on(int body, int ancestor) const;

  std::unique_ptr<mjModel, DeleteModel> model_;
  std::unique_ptr<mjData, DeleteData> data_;
  int base_, flange_, tip_;
  ToolKind tool_;
};

}  // namespace pal::sim
