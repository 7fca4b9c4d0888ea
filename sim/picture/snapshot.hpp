// What a picture shows: the state of the workcell at one instant, copied. Private to pal_sim.
#pragma once

#include <mujoco/mujoco.h>

#include <utility>
#include <vector>

#include "sim/workcell.hpp"

namespace pal::sim {

using ForcePoint = std::pair<double, double>;  // s, N

/// One or two kilobytes; the thread that draws needs nothing else of the run.
struct Snapshot {
  std::vector<mjtNum> positions;  // qpos
  std::vector<mjtNum> mocap_positions, mocap_turns;
  Sample sample;                  // the latest; its force is the one that is shown
  std::vector<ForcePoint> force;  // since the snapshot before
};

/// Of the last step. Before the first one the sample has poses and no forces. `logged`: how much of the log
/// the snapshot before has seen; moved on.
Snapshot take_snapshot(Workcell& workcell, std::size_t& logged);

}  // namespace pal::sim
