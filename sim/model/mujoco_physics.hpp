// One MuJoCo model and its state. Private to pal_sim: no public header includes this one.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <memory>
#include <vector>

#include "sim/arm/kinematics.hpp"
#include "sim/model/load.hpp"
#include "sim/scene.hpp"

namespace pal::sim {

struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

/// Which side of a contact a shape can be.
enum class Role : unsigned char {
  cell,   // the robot's surroundings, parts included
  arm,    // may touch nothing
  touch,  // made to touch: the pad's tip, the gripper's fingers
};

/// One finger of the gripper.
struct FingerIndex {
  int position = 0;  // into qpos
  int speed = 0;     // into qvel
  int drive = 0;     // into ctrl
  int pad_geom = 0;
};

/// What MuJoCo finds by name, found once.
struct ModelIndex {
  std::array<int, joint_count> position{};  // into qpos
  std::array<int, joint_count> speed{};     // into qvel
  std::array<int, joint_count> drive{};     // into ctrl
  int force = 0;                            // into sensordata
  int torque = 0;                           // into sensordata
  int base = 0;                             // body
  int wrist = 0;                            // site
  int tip = 0;                              // site
  int sensor = 0;                           // site
  int pad_joint = -1;                       // of the tool pad alone
  std::array<FingerIndex, 2> fingers{};     // of the gripper alone
  std::vector<Role> roles;                  // of each geom
};

/// What hangs on the force-torque sensor, as the arm was placed last: in the sensor's frame.
struct ToolMass {
  double weight = 0;                                   // N
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();    // m
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  // from the tip's axes to the sensor's
};

class GraspFriction;

/// Loads, places and steps the model. After construction `model` and `data` are never null.
class Physics {
 public:
  /// Loads a scene. Throws SceneError.
  explicit Physics(const Scene& scene);
  ~Physics();

  const mjModel& model() const { return *loaded_.model; }
  mjModel& model() { return *loaded_.model; }
  mjData& data() { return *data_; }
  const mjData& data() const { return *data_; }
  const ModelIndex& index() const { return index_; }
  const LoadedScene& loaded() const { return loaded_; }

  Joints joints() const;
  Joints joint_speeds() const;
  /// Torques that hold the arm against gravity and Coriolis forces and give its joints `acceleration`, as of
  /// the last step.
  Joints load(const Joints& acceleration);
  /// Puts the arm there at rest, the gripper open; forces and sensors follow.
  void place(const Joints& q);
  /// One step of 1 ms under these joint torques and forces of the fingers. Throws std::runtime_error when
  /// MuJoCo warns: the motion diverged, or contacts were left out.
  void step(const Joints& torques, const std::array<double, 2>& fingers);

  /// In frame 0 (the shoulder).
  Pose site_pose(int site) const;
  /// Where the robot's base stands in the world that MuJoCo counts from, the floor.
  Pose base_pose() const;
  const ToolMass& tool_mass() const { return tool_mass_; }

 private:
  ToolMass weigh_tool() const;
  void check_warnings() const;

  LoadedScene loaded_;
  std::unique_ptr<mjData, DeleteData> data_;
  ModelIndex index_;
  ToolMass tool_mass_;
  std::unique_ptr<GraspFriction> grasp_;
  std::vector<mjtNum> wanted_, inertial_;  // room for load(), one figure a degree of freedom
};

}  // namespace pal::sim
