#include "sim/picture/snapshot.hpp"

#include <utility>

#include "sim/model/mujoco_physics.hpp"

namespace pal::sim {

double shown_force(ToolKind tool, const Sample& sample) {
  return tool == ToolKind::gripper ? sample.grip_force : sample.contact_force;
}

Snapshot take_snapshot(Workcell& workcell, std::vector<HistoryPoint> history) {
  const mjModel& model = workcell.physics().model();
  const mjData& data = workcell.physics().data();
  Snapshot snapshot;
  snapshot.positions.assign(data.qpos, data.qpos + model.nq);
  snapshot.mocap_positions.assign(data.mocap_pos, data.mocap_pos + 3 * model.nmocap);
  snapshot.mocap_turns.assign(data.mocap_quat, data.mocap_quat + 4 * model.nmocap);
  if (!workcell.log().empty()) {
    snapshot.sample = workcell.log().back();
  } else {
    snapshot.sample.tool = workcell.tool().translation();
    snapshot.sample.joints = workcell.joints();
  }
  snapshot.history = std::move(history);
  if (const auto& fault = workcell.fault()) {
    snapshot.hit = fault->place;
    snapshot.fault = fault->text;
  }
  return snapshot;
}

}  // namespace pal::sim
