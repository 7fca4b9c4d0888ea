#include "sim/model/private/physics.hpp"

#include <stdexcept>

#include "sim/model/private/load.hpp"

namespace pal::sim {
namespace {

constexpr std::array<const char*, joint_count> joint_names{"joint1", "joint2", "joint3",
                                                           "joint4", "joint5", "joint6"};

int require(const mjModel& model, const Scene& scene, mjtObj kind, const char* kind_name, const char* name) {
  const int id = mj_name2id(&model, kind, name);
  if (id < 0)
    throw SceneError(scene.file.string(), std::string("the scene has no ") + kind_name + " '" + name + "'",
                     "include puma560.xml, which has it");
  return id;
}

ModelIndex find_names(const mjModel& model, const Scene& scene) {
  ModelIndex index;
  for (std::size_t i = 0; i < joint_count; ++i) {
    const int joint = require(model, scene, mjOBJ_JOINT, "joint", joint_names[i]);
    index.position[i] = model.jnt_qposadr[joint];
    index.speed[i] = model.jnt_dofadr[joint];
    index.drive[i] = require(model, scene, mjOBJ_ACTUATOR, "drive", joint_names[i]);
  }
  index.pad_joint = require(model, scene, mjOBJ_JOINT, "joint", "pad");
  index.pad_position = model.jnt_qposadr[index.pad_joint];
  index.force = model.sensor_adr[require(model, scene, mjOBJ_SENSOR, "sensor", "force")];
  index.torque = model.sensor_adr[require(model, scene, mjOBJ_SENSOR, "sensor", "torque")];
  index.base = require(model, scene, mjOBJ_BODY, "body", "base");
  index.wrist = require(model, scene, mjOBJ_SITE, "site", "wrist");
  index.tip = require(model, scene, mjOBJ_SITE, "site", "tip");
  index.tip_geom = require(model, scene, mjOBJ_GEOM, "geom", "tip");
  return index;
}

}  // namespace

Physics::Physics(const Scene& scene) : model_(load_model(scene)) {
  index_ = find_names(*model_, scene);
  if (model_->opt.timestep != 0.001)
    throw SceneError(scene.file.string(), "the scene changes the time step, which is 1 ms",
                     "take the timestep out of the scene's <option>");
  data_.reset(mj_makeData(model_.get()));
  if (!data_)
    throw SceneError(scene.file.string(), "there is no memory for the scene's state",
                     "make the scene smaller");
  wanted_.resize(static_cast<std::size_t>(model_->nv));
  inertial_.resize(wanted_.size());
  mj_forward(model_.get(), data_.get());
}

Joints Physics::joints() const {
  Joints q;
  for (std::size_t i = 0; i < joint_count; ++i)
    q[static_cast<Eigen::Index>(i)] = data_->qpos[index_.position[i]];
  return q;
}

Joints Physics::joint_speeds() const {
  Joints v;
  for (std::size_t i = 0; i < joint_count; ++i)
    v[static_cast<Eigen::Index>(i)] = data_->qvel[index_.speed[i]];
  return v;
}

Joints Physics::load(const Joints& acceleration) {
  for (std::size_t i = 0; i < joint_count; ++i)
    wanted_[static_cast<std::size_t>(index_.speed[i])] = acceleration[static_cast<Eigen::Index>(i)];
  mj_mulM(model_.get(), data_.get(), inertial_.data(), wanted_.data());
  Joints torques;
  for (std::size_t i = 0; i < joint_count; ++i)
    torques[static_cast<Eigen::Index>(i)] =
        data_->qfrc_bias[index_.speed[i]] + inertial_[static_cast<std::size_t>(index_.speed[i])];
  return torques;
}

void Physics::place(const Joints& q) {
  mj_resetData(model_.get(), data_.get());
  for (std::size_t i = 0; i < joint_count; ++i)
    data_->qpos[index_.position[i]] = q[static_cast<Eigen::Index>(i)];
  mj_forward(model_.get(), data_.get());
}

void Physics::step(const Joints& torques) {
  for (std::size_t i = 0; i < joint_count; ++i)
    data_->ctrl[index_.drive[i]] = torques[static_cast<Eigen::Index>(i)];
  mj_step(model_.get(), data_.get());
  for (const mjtWarning warning : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
    if (data_->warning[warning].number > 0)
      throw std::runtime_error(
          "the physics diverged: a position, speed or acceleration is out of all bounds");
}

Pose Physics::site_pose(int site) const {
  using Matrix = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
  const auto pose = [](const mjtNum* position, const mjtNum* rotation) {
    Pose result = Pose::Identity();
    result.translation() = Eigen::Map<const Eigen::Vector3d>(position);
    result.linear() = Matrix(rotation);
    return result;
  };
  const Pose base = pose(data_->xpos + 3 * index_.base, data_->xmat + 9 * index_.base);
  return base.inverse() * pose(data_->site_xpos + 3 * site, data_->site_xmat + 9 * site);
}

}  // namespace pal::sim
