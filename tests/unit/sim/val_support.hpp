// A VAL controller on a bench: an arm that follows at once, a hand, an ALTER port, and a person at the
// terminal.
#pragma once

#include <string>

#include "runtime/drivers/wire.hpp"
#include "sim/controller/motion_controller.hpp"
#include "sim/val/terminal.hpp"

namespace pal::sim::val::test {

using namespace std::chrono_literals;

class PlainArm final : public Arm {
 public:
  explicit PlainArm(const runtime::drivers::Timeline& timeline)
      : timeline_(timeline), motion(start(), 28ms, Pose::Identity()) {}

  static Joints start() {
    Joints q;
    q << 0.1, 0.8, -2.6, 0.2, -0.6, 0.3;
    return q;
  }
  Joints joints() const override { return motion.at(now()).position; }
  Joints goal() const override { return motion.goal(now()); }
  Pose tool() const override { return motion.tool(); }
  bool set_tool(const Pose& tool) override { return motion.set_tool(tool, now()); }
  std::optional<Refusal> move_joints(const Joints& goal, const MotionSpeed& speed) override {
    return motion.move_joints(goal, speed, now());
  }
  std::optional<Refusal> move_to(const Pose& goal, Configuration configuration,
                                 const MotionSpeed& speed) override {
    return motion.move_to(goal, configuration, speed, now());
  }
  std::optional<Refusal> move_straight(const Pose& goal, const MotionSpeed& speed) override {
    return motion.move_straight(goal, speed, now());
  }
  void stop() override { motion.stop(now()); }
  bool at_rest() const override { return motion.idle(now()); }
  runtime::Time look_again() const override { return std::max(motion.planned_end(now()), now() + 1ms); }
  std::string fault() const override { return broken; }
  std::string clear_fault() override {
    broken.clear();
    return {};
  }
  void break_down(const std::string& why) {
    broken = why;
    motion.hold(joints());
  }

 private:
  runtime::Time now() const { return timeline_.now(); }
  const runtime::drivers::Timeline& timeline_;

 public:
  mutable MotionController motion;
  std::string broken;
};

class PlainHand final : public Hand {
 public:
  explicit PlainHand(const runtime::drivers::Timeline& timeline) : timeline_(timeline) {}
  void open() override { move(true); }
  void close() override { move(false); }
  bool at_rest() const override { return timeline_.now() >= until_; }
  bool is_open = false;

 private:
  void move(bool to_open) {
    is_open = to_open;
    until_ = timeline_.now() + 300ms;
  }
  const runtime::drivers::Timeline& timeline_;
  runtime::Time until_{};
};

class PlainAlter final : public AlterControl {
 public:
  std::string open(const AlterMode& wanted) override {
    mode = wanted;
    opened = true;
    return {};
  }
  std::string close() override {
    opened = false;
    return std::exchange(trouble, {});
  }
  bool is_open() const override { return opened; }
  void on_end(std::function<void(const std::string&)> tell) override { ended = std::move(tell); }
  std::function<void(const std::string&)> ended;
  AlterMode mode;
  bool opened = false;
  std::string trouble;
};

/// The controller at one end of a wire, a person at the other.
struct Bench : runtime::drivers::LinkUser {
  Bench() { wire.a().connect(this); }
  void on_bytes(runtime::drivers::Bytes bytes) override { seen += runtime::drivers::as_text(bytes); }
  void on_break(std::string_view) override {}

  /// What appears within `time` after `keys` were typed.
  std::string type(std::string_view keys, runtime::Time time = 10s) {
    seen.clear();
    wire.a().write(runtime::drivers::as_bytes(keys));
    timeline.advance_to(timeline.now() + time);
    return std::exchange(seen, {});
  }
  /// The answer to a line that is carried out: without the echo and the prompt.
  std::string ask(const std::string& line, runtime::Time time = 30s) {
    const std::string all = type(line + "\r", time);
    const std::string echo = line + "\r\n";
    if (!all.starts_with(echo) || !all.ends_with(".")) return "no answer: " + all;
    return all.substr(echo.size(), all.size() - echo.size() - 1);
  }

  runtime::drivers::Timeline timeline;
  PlainArm arm{timeline};
  PlainHand hand{timeline};
  PlainAlter alter;
  Machine machine{.timeline = timeline, .arm = arm, .hand = &hand, .alter = &alter};
  runtime::drivers::Wire wire{timeline, {.baud = 9600}};
  Terminal terminal{wire.b(), machine};
  std::string seen;
};

}  // namespace pal::sim::val::test
