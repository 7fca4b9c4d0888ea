// One MuJoCo model and its state. Private to pal_sim: no public header includes this one.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <memory>
#include <vector>

#include "sim/arm/kinematics.hpp"
#include "sim/scene.hpp"

namespace pal::sim {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

/// What MuJoCo finds by name, found once.
struct ModelIndex {
  std::array<int, joint_count> position{};  // into qpos
  std::array<int, joint_count> speed{};     // into qvel
  std::array<int, joint_count> drive{};     // into ctrl
  int pad_position = 0;
  int force = 0;   // into sensordata
  int torque = 0;  // into sensordata
  int base = 0;    // body
  int wrist = 0;   // site
  int tip = 0;     // site
  int tip_geom = 0;
  int pad_joint = 0;
};

/// Loads, places and steps the model. After construction `model` and `data` are never null.
class Physics {
 public:
  /// Loads a scene. Throws SceneError.
  explicit Physics(const Scene& scene);

  const mjModel& model() const { return *model_; }
  mjModel& model() { return *model_; }
  mjData& data() { return *data_; }
  const mjData& data() const { return *data_; }
  const ModelIndex& index() const { return index_; }

  Joints joints() const;
  Joints joint_speeds() const;
  /// Torques that hold the arm against gravity and Coriolis forces and give its joints `acceleration`, as of
  /// the last step.
  Joints load(const Joints& acceleration);
  /// Puts the arm there at rest; forces and sensors follow.
  void place(const Joints& q);
  /// One step of 1 ms under these joint torques. Throws std::runtime_error if the motion diverged.
  void step(const Joints& torques);

  /// Poses in frame 0 (the shoulder).
  Pose site_pose(int site) const;

 private:
  std::unique_ptr<mjModel, DeleteModel> model_;
  std::unique_ptr<mjData, DeleteData> data_;
  ModelIndex index_;
  std::vector<mjtNum> wanted_, inertial_;  // room for load(), one figure a degree of freedom
};

}  // namespace pal::sim
