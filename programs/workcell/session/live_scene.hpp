// What the cell looks like, and where its bodies are while it works: the simulator's shapes as clients see
// them.
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "server/channels.hpp"
#include "server/scene.hpp"
#include "server/telemetry.hpp"
#include "sim/workcell.hpp"

namespace pal::workcell {

server::Scene scene_of(sim::Workcell& workcell);

/// The channels that SceneRecorder fills.
server::Channels scene_channels();

/// Copies poses and contacts 29 times in a second of the cell while the sink is watched, else once.
class SceneRecorder {
 public:
  /// Both outlive it.
  SceneRecorder(sim::Workcell& workcell, server::TelemetrySink& sink);
  /// Hands on what there is now: the cell may stand.
  void flush();

 private:
  void record();
  void hand_on();

  sim::Workcell& workcell_;
  server::TelemetrySink& sink_;
  std::vector<bool> moves_;  // by body
  runtime::Time due_{};
  std::vector<std::shared_ptr<const server::Rows>> waiting_;
  std::chrono::steady_clock::time_point handed_on_{};
  std::shared_ptr<void> listener_;
};

}  // namespace pal::workcell
