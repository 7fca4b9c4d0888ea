// What a picture shows: the state of the workcell at one instant, copied. Private to pal_sim.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "sim/workcell.hpp"

namespace pal::sim {

/// A kilobyte; the thread that draws needs nothing else of the run.
struct Snapshot {
  std::vector<mjtNum> positions;  // qpos
  std::vector<mjtNum> mocap_positions, mocap_turns;
  Sample sample;  // the latest; its force is the one that is shown
};

/// Of the last step. Before the first one the sample has poses and no forces.
Snapshot take_snapshot(Workcell& workcell);

}  // namespace pal::sim
