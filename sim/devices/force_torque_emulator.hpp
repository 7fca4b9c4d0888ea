// The ATI force-torque sensor and its controller, at the far end of a serial line.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "runtime/drivers/link.hpp"
#include "runtime/drivers/timeline.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/random.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

struct ForceTorqueEmulatorOptions {
  std::uint64_t seed = 1;
  /// The time of one conversion of all gauges, drawn evenly; equal ends fix it.
  runtime::Time shortest_conversion = std::chrono::microseconds(1800);
  runtime::Time longest_conversion = std::chrono::microseconds(2090);
  /// From control W, or from being switched on, to the prompt.
  runtime::Time boot = std::chrono::milliseconds(50);
  /// The controller waits until what it sends has left.
  runtime::drivers::LineSpeed line{38400, 10};
  // Standard deviations of one conversion: the resolution that the thesis states along x and y, and for
  // torques.
  double force_noise = 0.05;    // N
  double torque_noise = 0.003;  // N*m
  // The gauges show something under no load, and that drifts. Both are drawn evenly, for each axis.
  double most_offset = 0;         // N
  double most_torque_offset = 0;  // N*m
  double most_drift = 0;          // N a minute
  double most_torque_drift = 0;   // N*m a minute
  int z_step = 2;                 // counts: the force along z is half as fine as the others
};

/// Speaks the protocol of docs/workcell/force-torque.md: CV, CD A, CD B, SB, SU, SZ, QR, QS, an empty line,
/// ^T, ^W. Values are whole counts: 0.05 N, along z 0.10 N, 0.003 N*m. More than 65 N or 5 N*m on an axis,
/// with or without the bias, sets the overload byte and ends there.
class ForceTorqueEmulator final : public runtime::drivers::LinkUser {
 public:
  /// `load`: what acts on the sensor now (Workcell::wrench). All that is given outlives the emulator.
  ForceTorqueEmulator(runtime::drivers::Timeline& timeline, runtime::drivers::Link& link,
                      std::function<Wrench()> load, ForceTorqueEmulatorOptions options = {});
  ForceTorqueEmulator(const ForceTorqueEmulator&) = delete;
  ForceTorqueEmulator& operator=(const ForceTorqueEmulator&) = delete;
  ~ForceTorqueEmulator() override;

  void on_bytes(runtime::drivers::Bytes bytes) override;
  void on_break(std::string_view reason) override;

  /// A fault on demand: from now on each conversion takes longer by this time.
  void slow_down(runtime::Time more) { slower_by_ = more; }

 private:
  static constexpr std::size_t axes = 6;
  using Values = std::array<double, axes>;  // N and N*m
  struct Reading {
    bool overload = false;
    std::array<int, axes> counts{};
  };

  void boot();
  void ready();
  void take(std::uint8_t byte);
  void work_off();
  void obey(const std::string& line);
  void take_bias();
  void stream();
  void prompt();
  void busy_for(runtime::Time time, std::function<void()> then);
  runtime::Time conversion();
  Values convert();
  void draw_gauges();
  Reading read();
  std::vector<std::uint8_t> record();
  /// Both give back how long it takes until these bytes have left.
  runtime::Time send(const std::vector<std::uint8_t>& bytes);
  runtime::Time send(std::string_view text);

  runtime::drivers::Timeline& timeline_;
  runtime::drivers::Link& link_;
  std::function<Wrench()> load_;
  ForceTorqueEmulatorOptions options_;
  Random timing_;
  Random noise_;
  runtime::Time slower_by_{};
  Values offset_{};  // at time 0
  Values drift_{};   // a minute

  std::deque<std::uint8_t> input_;  // not looked at yet
  std::string line_;                // typed so far
  bool busy_ = false;
  bool streaming_ = false;
  runtime::drivers::Timeline::Token work_;
  runtime::Time sending_until_{};
  unsigned mask_ = 0x3f;
  bool binary_ = false;
  std::vector<Values> biases_;  // the newest last; what is read is less their sum
};

}  // namespace pal::sim
