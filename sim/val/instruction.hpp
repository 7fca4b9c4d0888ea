// Program instructions: what DO and the lines of a program carry out.
#pragma once

#include <optional>
#include <string>

#include "sim/val/machine.hpp"

namespace pal::sim::val {

/// Carries out one instruction after another. Each is begun, and then asked until it is over.
class Instruction {
 public:
  /// `program`: whether it is a program's, which has the arm to itself while it runs.
  Instruction(Machine& machine, bool program) : machine_(machine), program_(program) {}

  /// Throws Error. Returns what is to be shown, which is nothing in most cases.
  std::string begin(Line line);
  /// When to ask again; nothing: it is over. Throws Error when the arm has stopped for a fault.
  std::optional<runtime::Time> pending();
  /// It is over, as it stands.
  void abandon() { waits_for_ = Waits::nothing; }

 private:
  enum class Waits { nothing, time, motion, hand };
  struct Verb;
  static const Verb verbs[];

  void need_arm() const;
  MotionSpeed speed();
  Configuration configuration();
  void begun(const std::optional<Refusal>& refusal);
  void move_joints_to(const Pose& place);
  void move_straight_to(const Pose& place);

  void delay(Line& line);
  void open_hand(Line& line);
  void close_hand(Line& line);
  void set_speed(Line& line);
  void set_location(Line& line);
  void assign(Line& line, const std::string& name);
  void drive(Line& line);
  void depart(Line& line);
  void depart_straight(Line& line);
  void approach(Line& line);
  void approach_straight(Line& line);
  void move(Line& line);
  void move_straight(Line& line);
  void ready(Line& line);
  void take_here(Line& line);
  void open_alter(Line& line);
  void close_alter(Line& line);
  void type(Line& line);
  void nothing(Line& line);

  Machine& machine_;
  bool program_;
  Waits waits_for_ = Waits::nothing;
  runtime::Time until_{};
  std::string shown_;
};

/// BASE dx, dy, dz, rotation and TOOL location: the monitor and programs know them alike. Throw Error.
void set_base(Machine& machine, Line& line);
void set_tool(Machine& machine, Line& line);
/// RIGHTY, LEFTY, ABOVE, BELOW, FLIP, NOFLIP. False: another word.
bool set_configuration(Machine& machine, const std::string& word);

}  // namespace pal::sim::val
