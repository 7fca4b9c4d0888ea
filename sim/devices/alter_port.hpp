// The robot controller's ALTER port: asks for a relative motion every 28 ms, and moves the arm by it.
#pragma once

#include <cstdint>
#include <optional>

#include "runtime/device.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

struct AlterOptions {
  std::string name = "alter";
  /// From open() to the first event, within [0, 28 ms]; drawn by the seed if not given.
  std::optional<runtime::Time> phase;
  std::uint64_t seed = 1;
  /// An event that is not answered for so long stops the arm.
  runtime::Time answer_within = std::chrono::milliseconds(20);
  CorrectionFrame frame = CorrectionFrame::tool;
};

/// Ports: `tick` from the device; `correction` to it (dx, dy, dz in mm, rx, ry, rz in deg).
///
/// A correction that answers the event of one cycle is moved evenly in the next: between its answer and the
/// next event the controller computes the joint set-points. close() takes no further corrections; those
/// accepted before are still moved, at most until the end of the next cycle, then the arm stands still. A
/// fault (no answer in time, an answer that nobody asked for, a motion that the arm cannot make) stops the
/// arm at once.
class AlterPort final : public runtime::Device {
 public:
  /// The workcell must outlive the port.
  AlterPort(Workcell& workcell, AlterOptions options);

  const std::string& name() const override { return options_.name; }
  const std::vector<runtime::PortSpec>& ports() const override { return ports_; }
  void attach(runtime::DeviceHost& host) override;
  void open() override;
  void receive(std::size_t port, std::span<const double> fields) override;
  void close() override;

  /// The phase given or drawn.
  runtime::Time phase() const { return phase_; }

 private:
  void tick();
  void expect_answer(std::uint32_t serial);
  void fail(std::string reason);

  Workcell& workcell_;
  AlterOptions options_;
  std::vector<runtime::PortSpec> ports_;
  runtime::DeviceHost* host_ = nullptr;
  runtime::Time phase_{};
  runtime::Time last_tick_{};
  std::uint32_t serial_ = 0;
  bool open_ = false;
  bool unanswered_ = false;
};

}  // namespace pal::sim
