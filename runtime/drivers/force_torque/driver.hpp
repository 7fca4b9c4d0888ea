// The driver of the ATI force-torque sensor.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/drivers/force_torque/codec.hpp"
#include "runtime/drivers/force_torque/zero.hpp"
#include "runtime/drivers/linked_driver.hpp"

namespace pal::runtime::drivers {

struct ForceTorqueDriverOptions {
  std::string name = "force-torque";
  /// What the tool's weight alone puts on the sensor now, by the arm's pose. Empty: nothing.
  std::function<force_torque::Load()> tool_weight;
  // How long the sensor may take before it is in trouble.
  Time boot_within = std::chrono::seconds(1);
  /// A sensor takes longer than this to start. A prompt that comes sooner was waiting in the line: it is of
  /// an earlier start.
  Time boot_takes = std::chrono::milliseconds(40);
  Time prompt_within = std::chrono::milliseconds(200);
  Time record_within = std::chrono::milliseconds(20);
};

/// Ports: `request wrench` to the device; `wrench` from it (fx, fy, fz in N, tx, ty, tz in N*m; pressing
/// gives a negative fz). `request record` and `record` are the same with a seventh field, `overload`
/// (BOOLEAN). It says that an axis has left its range of 65 N or 5 N*m, and that its value stays at the
/// limit. An overload is not a fault.
///
/// The tool's weight is taken out by its pose, and the gauges' zero is taken once, in free air: before the
/// station's first skill (commission()), or before the first skill after that at which the sensor answers. It
/// is kept across skills and across a restart of the sensor. A tool that is not in free air then is trouble
/// (force_torque::ZeroPoint). Another tool is another driver.
///
/// Requests are served one at a time, in the order in which they come. A missing or wrong record is a fault.
class ForceTorqueDriver final : public LinkedDriver {
 public:
  ForceTorqueDriver(Timeline& timeline, Link& link, ForceTorqueDriverOptions options = {});

  bool commission() override;
  void prepare() override;
  /// The start-up dialogue is over, with success or not.
  bool ready() const override { return step_ == Step::none; }
  void open() override {}
  void receive(std::size_t port, std::span<const double> fields) override;
  bool withdraw(std::size_t port) override;
  void close() override;

 private:
  enum class Step { none, drain, boot, binary, axes, discard, look };

  void arrived(Bytes bytes) override;
  void give_up() override;
  std::string missing() const override { return codec_.missing(); }
  void late() override;

  void start(Step step);
  void start_again();
  force_torque::Load without_weight() const;
  void command(Step step, std::string_view text);
  void ask_for_record(Time within);
  void serve_next();
  void answered();
  void deliver();

  ForceTorqueDriverOptions options_;
  force_torque::Codec codec_;
  Time booted_{};  // when control W was sent last
  Step step_ = Step::none;
  bool started_ = false;  // the sensor sends binary records of all axes
  force_torque::ZeroPoint zero_;
  std::vector<std::size_t> waiting_;  // ports of requests, oldest first; the first one is served if serving_
  bool serving_ = false;
};

}  // namespace pal::runtime::drivers
