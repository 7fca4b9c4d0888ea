// What a picture shows: the state of the workcell at one instant, copied. Private to pal_sim.
#pragma once

#include <mujoco/mujoco.h>

#include <optional>
#include <string>
#include <vector>

#include "sim/picture/peak_history.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

/// One or two kilobytes; the thread that draws needs nothing else of the run.
struct Snapshot {
  std::vector<mjtNum> positions;  // qpos
  std::vector<mjtNum> mocap_positions, mocap_turns;
  Sample sample;                       // the latest; its force is the one that is shown
  std::vector<HistoryPoint> history;   // of the force that is shown, since the snapshot before
  std::optional<Eigen::Vector3d> hit;  // where the arm has met something, in frame 0, m
  std::string fault;                   // why the arm has stopped by itself; empty: it has not
};

/// The force that pictures show of this tool: the grip of the gripper, the contact force of others.
double shown_force(ToolKind tool, const Sample& sample);

/// Of the last step. Before the first one the sample has poses and no forces.
Snapshot take_snapshot(Workcell& workcell, std::vector<HistoryPoint> history);

}  // namespace pal::sim
