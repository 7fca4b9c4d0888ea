#include "sim/picture/snapshot.hpp"

#include "sim/model/mujoco_physics.hpp"

namespace pal::sim {

Snapshot take_snapshot(Workcell& workcell, std::size_t& logged) {
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
  for (; logged < workcell.log().size(); ++logged) {
    const Sample& sample = workcell.log()[logged];
    snapshot.force.emplace_back(std::chrono::duration<double>(sample.time).count(), sample.contact_force);
  }
  return snapshot;
}

}  // namespace pal::sim
