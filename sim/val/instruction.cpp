#include "sim/val/instruction.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "runtime/drivers/alter/protocol.hpp"
#include "sim/val/error.hpp"

namespace pal::sim::val {
namespace {

constexpr runtime::Time cycle = runtime::drivers::alter::period;  // faults are looked for once in it

Error error_of(const Refusal& refusal) {
  const std::string joint = "Jt " + std::to_string(refusal.joint + 1);
  switch (refusal.cause) {
    case Refusal::Cause::too_far:
      return Error("Location too far");
    case Refusal::Cause::too_near:
      return Error("Location too close");
    case Refusal::Cause::joint_range:
      return Error("Joint out of range", joint);
    case Refusal::Cause::joint_speed:
      return Error("Joint too fast", joint);
    case Refusal::Cause::tool_speed:
      return Error("Tool too fast");
    case Refusal::Cause::busy:
      break;
  }
  return Error("Arm is busy", refusal.text);
}

Pose back_from(const Pose& place, double distance) {
  return place * Eigen::Translation3d(0, 0, -1e-3 * distance);
}

}  // namespace

struct Instruction::Verb {
  const char* word;
  void (Instruction::*carry_out)(Line&);
};

// An abbreviation means the first that it fits.
const Instruction::Verb Instruction::verbs[] = {{"MOVE", &Instruction::move},
                                                {"MOVES", &Instruction::move_straight},
                                                {"APPRO", &Instruction::approach},
                                                {"APPROS", &Instruction::approach_straight},
                                                {"APPROX", &Instruction::approach_straight},
                                                {"DEPART", &Instruction::depart},
                                                {"DEPARTS", &Instruction::depart_straight},
                                                {"DRIVE", &Instruction::drive},
                                                {"READY", &Instruction::ready},
                                                {"DELAY", &Instruction::delay},
                                                {"OPENI", &Instruction::open_hand},
                                                {"CLOSEI", &Instruction::close_hand},
                                                {"SPEED", &Instruction::set_speed},
                                                {"SET", &Instruction::set_location},
                                                {"HERE", &Instruction::take_here},
                                                {"ALTER", &Instruction::open_alter},
                                                {"NOALTER", &Instruction::close_alter},
                                                {"TYPE", &Instruction::type},
                                                {"BREAK", &Instruction::nothing}};

std::string Instruction::begin(Line line) {
  waits_for_ = Waits::nothing;
  shown_.clear();
  const std::optional<std::string> word = line.word();
  if (!word) throw Error("Missing instruction");
  if (line.take('=')) {
    assign(line, *word);
  } else if (*word == "BASE") {
    set_base(machine_, line);
  } else if (*word == "TOOL") {
    set_tool(machine_, line);
  } else if (!set_configuration(machine_, *word)) {
    constexpr std::size_t shortest = 3;  // DRI
    const auto fits = [&](const Verb& verb) { return *word == verb.word; };
    const auto begins = [&](const Verb& verb) {
      return word->size() >= shortest && std::string(verb.word).starts_with(*word);
    };
    const Verb* verb = std::find_if(std::begin(verbs), std::end(verbs), fits);
    if (verb == std::end(verbs)) verb = std::find_if(std::begin(verbs), std::end(verbs), begins);
    if (verb == std::end(verbs)) throw Error("Unknown instruction", *word);
    (this->*verb->carry_out)(line);
  }
  return shown_;
}

std::optional<runtime::Time> Instruction::pending() {
  const runtime::Time now = machine_.timeline.now();
  switch (waits_for_) {
    case Waits::nothing:
      return std::nullopt;
    case Waits::time:
      if (now < until_) return until_;
      break;
    case Waits::motion: {
      const std::string fault = machine_.arm.fault();
      if (!fault.empty()) {
        abandon();
        throw Error("Arm fault", fault);
      }
      if (!machine_.arm.at_rest()) return std::min(now + cycle, machine_.arm.look_again());
      break;
    }
    case Waits::hand:
      if (!machine_.hand->at_rest()) return now + cycle;
      break;
  }
  abandon();
  return std::nullopt;
}

void Instruction::need_arm() const {
  if (machine_.attached && !program_) throw Error("Arm is a program's");
  const std::string fault = machine_.arm.fault();
  if (!fault.empty()) throw Error("Arm fault", fault);
  if (machine_.alter != nullptr && machine_.alter->is_open()) throw Error("ALTER is open");
}

MotionSpeed Instruction::speed() {
  const ProgramSpeed wanted = machine_.next_speed.value_or(machine_.program_speed);
  machine_.next_speed.reset();
  const double monitor = machine_.monitor_speed / 100;
  if (!wanted.straight) return {monitor * wanted.percent / 100, {}};
  const double straight = monitor * *wanted.straight / 1000;
  return {std::min(1.0, straight / straight_line_speed), straight};
}

Configuration Instruction::configuration() {
  Configuration wanted = configuration_of(machine_.arm.goal());
  wanted.righty = machine_.righty.value_or(wanted.righty);
  wanted.above = machine_.above.value_or(wanted.above);
  wanted.flip = machine_.flip.value_or(wanted.flip);
  return wanted;
}

void Instruction::begun(const std::optional<Refusal>& refusal) {
  if (refusal) throw error_of(*refusal);
  waits_for_ = Waits::motion;
}

void Instruction::move_joints_to(const Pose& place) {
  need_arm();
  const Configuration wanted = configuration();
  machine_.righty = machine_.above = machine_.flip = std::nullopt;
  begun(machine_.arm.move_to(machine_.base * place, wanted, speed()));
}

void Instruction::move_straight_to(const Pose& place) {
  need_arm();
  if (configuration() != configuration_of(machine_.arm.goal()))
    throw Error("Configuration", "no straight line changes it, use MOVE");
  begun(machine_.arm.move_straight(machine_.base * place, speed()));
}

void Instruction::move(Line& line) {
  const Pose place = location(line, machine_.values());
  line.end();
  move_joints_to(place);
}

void Instruction::move_straight(Line& line) {
  const Pose place = location(line, machine_.values());
  line.end();
  move_straight_to(place);
}

void Instruction::approach(Line& line) {
  const Pose place = location(line, machine_.values());
  line.take(',');
  const double distance = number(line, machine_.values());
  line.end();
  move_joints_to(back_from(place, distance));
}

void Instruction::approach_straight(Line& line) {
  const Pose place = location(line, machine_.values());
  line.take(',');
  const double distance = number(line, machine_.values());
  line.end();
  move_straight_to(back_from(place, distance));
}

void Instruction::depart(Line& line) {
  const double distance = number(line, machine_.values());
  line.end();
  move_joints_to(back_from(machine_.values().here, distance));
}

void Instruction::depart_straight(Line& line) {
  const double distance = number(line, machine_.values());
  line.end();
  move_straight_to(back_from(machine_.values().here, distance));
}

void Instruction::drive(Line& line) {
  const Values values = machine_.values();
  const long joint = whole_number(line, values, 1, joint_count);
  line.expect(',');
  const double change = number(line, values);
  double percent = 100;
  if (line.take(',')) percent = number(line, values);
  line.end();
  if (percent <= 0 || percent > 100) throw Error("Illegal speed", "above 0 to 100 is wanted");
  need_arm();
  Joints goal = machine_.arm.goal();
  goal[joint - 1] += radians(change);
  begun(machine_.arm.move_joints(goal, {machine_.monitor_speed / 100 * percent / 100, {}}));
}

void Instruction::ready(Line& line) {
  line.end();
  need_arm();
  Joints upright = Joints::Zero();
  upright[1] = radians(90);
  upright[2] = radians(-90);
  begun(machine_.arm.move_joints(upright, speed()));
}

void Instruction::delay(Line& line) {
  const double seconds = number(line, machine_.values());
  line.end();
  constexpr double longest = 3600;
  if (seconds < 0 || seconds > longest) throw Error("Illegal value", "0 to 3600 is wanted");
  waits_for_ = Waits::time;
  until_ = machine_.timeline.now() + runtime::Time(static_cast<runtime::Time::rep>(seconds * 1e9));
}

void Instruction::open_hand(Line& line) {
  line.end();
  if (machine_.hand == nullptr) throw Error("No hand");
  machine_.hand->open();
  waits_for_ = Waits::hand;
}

void Instruction::close_hand(Line& line) {
  line.end();
  if (machine_.hand == nullptr) throw Error("No hand");
  machine_.hand->close();
  waits_for_ = Waits::hand;
}

void Instruction::set_speed(Line& line) {
  const double value = number(line, machine_.values());
  ProgramSpeed wanted{value, {}};
  bool always = false;
  while (const std::optional<std::string> word = line.word()) {
    if (*word == "MMPS") {
      wanted = {100, value};
    } else if (*word == "ALWAYS") {
      always = true;
    } else {
      throw Error("Syntax error", "MMPS or ALWAYS may follow");
    }
  }
  line.end();
  const double most = wanted.straight ? 1000 * straight_line_speed : 100;
  if (value <= 0 || value > most) {
    std::array<char, 48> range{};
    std::snprintf(range.data(), range.size(), "above 0 to %.0f is wanted", most);
    throw Error("Illegal speed", range.data());
  }
  if (always) machine_.program_speed = wanted;
  machine_.next_speed = always ? std::nullopt : std::optional(wanted);
}

void Instruction::set_location(Line& line) {
  const std::string name = line.name();
  line.expect('=');
  const Pose place = location(line, machine_.values());
  line.end();
  machine_.store.locations[name] = place;
}

void Instruction::assign(Line& line, const std::string& name) {
  if (name.size() > longest_name) throw Error("Name too long", name);
  const double value = number(line, machine_.values());
  line.end();
  machine_.store.reals[name] = value;
}

void Instruction::take_here(Line& line) {
  const std::string name = line.name();
  line.end();
  machine_.store.locations[name] = machine_.here(machine_.arm.joints());
}

void Instruction::open_alter(Line& line) {
  constexpr long cumulative = 1, world = 2, joints = 4, external = 16;
  line.expect('(');
  // Of one number the mode; of two the port, which is the only one, and the mode.
  long mode = whole_number(line, machine_.values(), -1, external + joints + world + cumulative);
  if (line.take(',')) mode = whole_number(line, machine_.values(), 0, external + joints + world + cumulative);
  line.expect(')');
  line.end();
  if (mode < 0 || (mode & ~(external | joints | world | cumulative)) != 0)
    throw Error("Illegal value", "a mode is the sum of 1 (cumulative), 2 (world), 4 (joints) and 16");
  if (machine_.alter == nullptr) throw Error("No ALTER port");
  need_arm();
  const std::string problem = machine_.alter->open(
      {.world = (mode & world) != 0, .cumulative = (mode & cumulative) != 0, .joints = (mode & joints) != 0});
  if (!problem.empty()) throw Error("ALTER", problem);
}

void Instruction::close_alter(Line& line) {
  line.end();
  if (machine_.alter == nullptr) throw Error("No ALTER port");
  const std::string problem = machine_.alter->close();
  if (!problem.empty()) throw Error("ALTER", problem);
  waits_for_ = Waits::motion;  // what was accepted is still moved
}

void Instruction::type(Line& line) {
  const double value = number(line, machine_.values());
  line.end();
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.8g", value);
  shown_ = text.data();
}

void Instruction::nothing(Line& line) {
  line.end();
}

void set_base(Machine& machine, Line& line) {
  std::array<double, 4> figures{};
  for (std::size_t i = 0; i < figures.size() && !line.done(); ++i) {
    if (i > 0) line.expect(',');
    figures[i] = number(line, machine.values());
  }
  line.end();
  machine.base = Eigen::Translation3d(1e-3 * Eigen::Vector3d(figures[0], figures[1], figures[2])) *
                 Eigen::AngleAxisd(radians(figures[3]), Eigen::Vector3d::UnitZ());
}

void set_tool(Machine& machine, Line& line) {
  const Pose tool = line.done() ? Pose::Identity() : location(line, machine.values());
  line.end();
  if (!machine.arm.set_tool(tool)) throw Error("Arm is busy", "the tool changes only at rest");
}

bool set_configuration(Machine& machine, const std::string& word) {
  if (word == "RIGHTY" || word == "LEFTY") {
    machine.righty = word == "RIGHTY";
  } else if (word == "ABOVE" || word == "BELOW") {
    machine.above = word == "ABOVE";
  } else if (word == "FLIP" || word == "NOFLIP") {
    machine.flip = word == "FLIP";
  } else {
    return false;
  }
  return true;
}

}  // namespace pal::sim::val
