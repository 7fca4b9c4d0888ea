// The six-axis force-torque sensor between wrist and tool.
#pragma once

#include <cstdint>
#include <optional>

#include "runtime/device.hpp"
#include "sim/random.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

struct ForceTorqueOptions {
  std::string name = "force-torque";
  /// From a request to its answer: drawn evenly by the seed; equal ends fix it.
  runtime::Time shortest = std::chrono::microseconds(5700);
  runtime::Time longest = std::chrono::milliseconds(6);
  std::uint64_t seed = 1;
  /// Standard deviations of the noise: the resolution that the thesis gives for the sensor along x and y, and
  /// for torques.
  double force_noise = 0.05;    // N
  double torque_noise = 0.003;  // N*m
};

/// Ports: `request wrench` to the device; `wrench` from it (fx, fy, fz in N, tx, ty, tz in N*m, in the
/// sensor's frame, z out of the tool: pressing gives a negative fz).
///
/// open() makes the load of this moment (the tool's weight) the zero. A reading is the force at the instant
/// at which its answer leaves, with noise, rounded to whole counts (20 a newton, 333.33 a newton-metre). More
/// than 65 N or 5 N*m is an overload, which is a fault. A request that comes while another is served waits.
class ForceTorqueSensor final : public runtime::Device {
 public:
  /// The workcell must outlive the sensor.
  ForceTorqueSensor(const Workcell& workcell, ForceTorqueOptions options);

  const std::string& name() const override { return options_.name; }
  const std::vector<runtime::PortSpec>& ports() const override { return ports_; }
  void attach(runtime::DeviceHost& host) override;
  void open() override;
  void receive(std::size_t port, std::span<const double> fields) override;
  bool withdraw(std::size_t port) override;
  void close() override;

 private:
  void begin();
  void finish(std::uint32_t serial);

  const Workcell& workcell_;
  ForceTorqueOptions options_;
  std::vector<runtime::PortSpec> ports_;
  Random timing_;
  Random noise_;
  Wrench zero_;
  runtime::DeviceHost* host_ = nullptr;
  std::uint32_t serial_ = 0;
  int waiting_ = 0;
  bool busy_ = false;
};

}  // namespace pal::sim
