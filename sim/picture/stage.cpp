#include "sim/picture/stage.hpp"

#include <stdexcept>

namespace pal::sim {
namespace {

int require(const mjModel& model, mjtObj kind, const char* name) {
  const int id = mj_name2id(&model, kind, name);
  if (id < 0) throw std::runtime_error(std::string("the model has no '") + name + "'");
  return id;
}

ToolKind tool_in(const mjModel& model) {
  if (mj_name2id(&model, mjOBJ_BODY, "finger left") >= 0) return ToolKind::gripper;
  return mj_name2id(&model, mjOBJ_BODY, "range finder") >= 0 ? ToolKind::range_finder : ToolKind::pad;
}

}  // namespace

Stage::Stage(const mjModel& model)
    : model_(mj_copyModel(nullptr, &model)),
      data_(model_ ? mj_makeData(model_.get()) : nullptr),
      base_(require(model, mjOBJ_BODY, "base")),
      flange_(model.site_bodyid[require(model, mjOBJ_SITE, "flange")]),
      tip_(require(model, mjOBJ_SITE, "tip")),
      tool_(tool_in(model)) {
  if (!model_ || !data_) throw std::runtime_error("there is no memory for a copy of the model");
}

void Stage::show(const Snapshot& snapshot) {
  std::copy(snapshot.positions.begin(), snapshot.positions.end(), data_->qpos);
  std::copy(snapshot.mocap_positions.begin(), snapshot.mocap_positions.end(), data_->mocap_pos);
  std::copy(snapshot.mocap_turns.begin(), snapshot.mocap_turns.end(), data_->mocap_quat);
  mj_kinematics(model_.get(), data_.get());
  mj_comPos(model_.get(), data_.get());
  mj_camlight(model_.get(), data_.get());
}

Eigen::Vector3d Stage::tip() const {
  return Eigen::Map<const Eigen::Vector3d>(data_->site_xpos + 3 * tip_);
}

Eigen::Matrix3d Stage::tip_turn() const {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->site_xmat + 9 * tip_);
}

Eigen::Vector3d Stage::in_world(const Eigen::Vector3d& place) const {
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> turn(data_->xmat + 9 * base_);
  return base() + turn * place;
}

Eigen::Vector3d Stage::pointing() const {
  const mjtNum* turn = data_->site_xmat + 9 * tip_;
  return {turn[2], turn[5], turn[8]};
}

Eigen::Vector3d Stage::base() const {
  return Eigen::Map<const Eigen::Vector3d>(data_->xpos + 3 * base_);
}

bool Stage::hangs_on(int body, int ancestor) const {
  while (body != 0 && body != ancestor) body = model_->body_parentid[body];
  return body == ancestor;
}

bool Stage::of_arm(int body) const {
  return hangs_on(body, base_);
}

bool Stage::of_tool(int body) const {
  return hangs_on(body, flange_);
}

}  // namespace pal::sim
