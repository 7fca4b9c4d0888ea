#include "sim/model/mujoco_physics.hpp"

#include <stdexcept>
#include <string>

#include "sim/model/grasp.hpp"
#include "sim/model/names.hpp"

namespace pal::sim {
namespace {

Pose to_pose(const mjtNum* position, const mjtNum* rotation) {
  Pose result = Pose::Identity();
  result.translation() = Eigen::Map<const Eigen::Vector3d>(position);
  result.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation);
  return result;
}

struct Warning {
  mjtWarning kind;
  const char* text;
};

constexpr std::array<Warning, 7> warnings{
    {{mjWARN_INERTIA, "the inertia of the arm or of a part became singular"},
     {mjWARN_CONTACTFULL, "there are more contacts than the scene has room for, and some were left out"},
     {mjWARN_CNSTRFULL, "there are more constraints than the scene has room for, and some were left out"},
     {mjWARN_BADQPOS, "the physics diverged: a position is out of all bounds"},
     {mjWARN_BADQVEL, "the physics diverged: a speed is out of all bounds"},
     {mjWARN_BADQACC, "the physics diverged: an acceleration is out of all bounds"},
     {mjWARN_BADCTRL, "a drive was given a torque that is no number"}}};

}  // namespace

Physics::Physics(const Scene& scene) : loaded_(load_scene(scene)), grasp_(std::make_unique<GraspFriction>()) {
  index_ = find_names(*loaded_.model, loaded_.tool, scene);
  let_arm_meet_itself(*loaded_.model, index_);
  data_.reset(mj_makeData(loaded_.model.get()));
  if (!data_)
    throw SceneError(scene.file.string(), "there is no memory for the scene's state",
                     "make the scene smaller");
  wanted_.resize(static_cast<std::size_t>(loaded_.model->nv));
  inertial_.resize(wanted_.size());
  mj_forward(loaded_.model.get(), data_.get());
}

Physics::~Physics() = default;

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
  mj_mulM(loaded_.model.get(), data_.get(), inertial_.data(), wanted_.data());
  Joints torques;
  for (std::size_t i = 0; i < joint_count; ++i)
    torques[static_cast<Eigen::Index>(i)] =
        data_->qfrc_bias[index_.speed[i]] + inertial_[static_cast<std::size_t>(index_.speed[i])];
  return torques;
}

void Physics::place(const Joints& q) {
  mj_resetData(loaded_.model.get(), data_.get());
  for (std::size_t i = 0; i < joint_count; ++i)
    data_->qpos[index_.position[i]] = q[static_cast<Eigen::Index>(i)];
  if (loaded_.tool == ToolKind::gripper)
    for (const FingerIndex& finger : index_.fingers) data_->qpos[finger.position] = gripper_opening / 2e3;
  mj_forward(loaded_.model.get(), data_.get());
  tool_mass_ = weigh_tool();
}

ToolMass Physics::weigh_tool() const {
  const int body = model().site_bodyid[index_.sensor];
  const Pose sensor = site_pose(index_.sensor);
  const Eigen::Vector3d centre = Eigen::Map<const Eigen::Vector3d>(data().subtree_com + 3 * body);
  ToolMass mass;
  mass.weight =
      model().body_subtreemass[body] * Eigen::Map<const Eigen::Vector3d>(model().opt.gravity).norm();
  mass.centre = sensor.inverse() * (base_pose().inverse() * centre);
  mass.turn = sensor.linear().transpose() * site_pose(index_.tip).linear();
  return mass;
}

void Physics::step(const Joints& torques, const std::array<double, 2>& fingers) {
  for (std::size_t i = 0; i < joint_count; ++i)
    data_->ctrl[index_.drive[i]] = torques[static_cast<Eigen::Index>(i)];
  if (loaded_.tool == ToolKind::gripper)
    for (std::size_t i = 0; i < fingers.size(); ++i) data_->ctrl[index_.fingers[i].drive] = fingers[i];
  mj_step1(loaded_.model.get(), data_.get());
  if (loaded_.tool == ToolKind::gripper) grasp_->correct(*loaded_.model, *data_, index_);
  mj_step2(loaded_.model.get(), data_.get());
  check_warnings();
}

void Physics::check_warnings() const {
  for (const Warning& warning : warnings)
    if (data_->warning[warning.kind].number > 0) throw std::runtime_error(warning.text);
}

Pose Physics::base_pose() const {
  return to_pose(data_->xpos + 3 * index_.base, data_->xmat + 9 * index_.base);
}

Pose Physics::site_pose(int site) const {
  return base_pose().inverse() * to_pose(data_->site_xpos + 3 * site, data_->site_xmat + 9 * site);
}

}  // namespace pal::sim
