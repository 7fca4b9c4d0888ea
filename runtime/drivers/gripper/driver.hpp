// The driver of the gripper's feedback: how wide its fingers stand, and how hard they press.
#pragma once

#include <string>
#include <vector>

#include "runtime/drivers/linked_driver.hpp"
#include "runtime/drivers/wire.hpp"

namespace pal::runtime::drivers {

namespace gripper {
inline constexpr LineSpeed line{38400, 10};
}  // namespace gripper

struct GripperDriverOptions {
  std::string name = "gripper";
  /// How long the gripper may take to answer before it is in trouble.
  Time answer_within = std::chrono::milliseconds(50);
};

/// Ports: `request state` to the device; `state` from it (width in mm, force in N, holding BOOLEAN: the
/// fingers have stopped on something). VAL opens and closes the gripper; this line only reports
/// (docs/workcell/gripper.md).
///
/// prepare() asks once, to check that the gripper is there. A missing or wrong answer is a fault.
class GripperDriver final : public LinkedDriver {
 public:
  GripperDriver(Timeline& timeline, Link& link, GripperDriverOptions options = {});

  void prepare() override;
  bool ready() const override { return !preparing_; }
  void open() override {}
  void receive(std::size_t port, std::span<const double> fields) override;
  bool withdraw(std::size_t port) override;
  void close() override;

 private:
  void arrived(Bytes bytes) override;
  void give_up() override;
  std::string missing() const override;

  void ask();
  void serve_next();
  void take(const std::string& line);

  GripperDriverOptions options_;
  std::string line_;  // what has come of the answer
  int waiting_ = 0;
  bool asking_ = false;
  bool serving_ = false;
  bool preparing_ = false;
};

}  // namespace pal::runtime::drivers
