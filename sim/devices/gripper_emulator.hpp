// The gripper's feedback at the far end of a serial line: reports the state of its fingers.
#pragma once

#include <functional>
#include <string>

#include "runtime/drivers/link.hpp"
#include "runtime/drivers/timeline.hpp"
#include "sim/random.hpp"

namespace pal::sim {

/// What the gripper feels.
struct GripperState {
  double width = 0;  // between the fingers, mm
  double force = 0;  // with which each of them presses, N
  bool holding = false;
};

struct GripperEmulatorOptions {
  std::uint64_t seed = 1;
  /// From the end of a question to the beginning of its answer, drawn evenly; equal ends fix it.
  runtime::Time shortest_wait = std::chrono::microseconds(1000);
  runtime::Time longest_wait = std::chrono::microseconds(1400);
  // Standard deviations of a reading.
  double width_noise = 0.02;  // mm
  double force_noise = 0.2;   // N
};

/// Speaks the protocol of docs/workcell/gripper.md: a line STATE is answered with width, force and holding.
class GripperEmulator final : public runtime::drivers::LinkUser {
 public:
  /// `state`: how the gripper stands now. All that is given outlives the emulator.
  GripperEmulator(runtime::drivers::Timeline& timeline, runtime::drivers::Link& link,
                  std::function<GripperState()> state, GripperEmulatorOptions options = {});
  GripperEmulator(const GripperEmulator&) = delete;
  GripperEmulator& operator=(const GripperEmulator&) = delete;
  ~GripperEmulator() override;

  void on_bytes(runtime::drivers::Bytes bytes) override;
  void on_break(std::string_view) override { line_.clear(); }

  /// A fault on demand: from now on each answer takes longer by this time.
  void slow_down(runtime::Time more) { slower_by_ = more; }

 private:
  void obey(const std::string& line);
  void answer();

  runtime::drivers::Timeline& timeline_;
  runtime::drivers::Link& link_;
  std::function<GripperState()> state_;
  GripperEmulatorOptions options_;
  Random timing_;
  Random noise_;
  runtime::Time slower_by_{};
  std::string line_;
  runtime::drivers::Timeline::Token work_;
};

}  // namespace pal::sim
