// The cell's live channels: what each shows, and the numbers that the simulation copies for them.
#pragma once

#include <memory>
#include <vector>

#include "programs/workcell/session/skills.hpp"
#include "server/channels.hpp"
#include "server/telemetry.hpp"
#include "sim/workcell.hpp"

namespace pal::workcell {

/// All of a cell with this tool, with the limits that the skills declare; their raw numbers are those of
/// LiveRecorder. Throws Failure if a limit names a channel, or a field of it, that a cell has with no tool.
server::Channels live_channels(sim::ToolKind tool, const std::vector<KnownSkill>& skills);

/// Copies each step of the physics into records, as long as the sink is watched.
class LiveRecorder {
 public:
  /// Both outlive it.
  LiveRecorder(sim::Workcell& workcell, server::TelemetrySink& sink);
  /// Hands on what waits to be whole: the cell may stand now.
  void flush() { writer_.flush(); }

 private:
  void record(const sim::Sample& sample);

  sim::Workcell& workcell_;
  server::TelemetrySink& sink_;
  server::BlockWriter writer_;
  Eigen::Vector3d last_tool_ = Eigen::Vector3d::Zero();
  runtime::Time last_time_{-1};
  std::shared_ptr<void> listener_;
};

}  // namespace pal::workcell
