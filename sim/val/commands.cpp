// The monitor's commands: which there are, how far they may be shortened, and the refusal of others.
#include <algorithm>
#include <cstdio>

#include "sim/val/error.hpp"
#include "sim/val/monitor.hpp"

namespace pal::sim::val {

struct Monitor::Command {
  const char* word;
  std::size_t shortest;  // letters that are enough
  void (Monitor::*carry_out)(Line&);
  const char* use;
};

const Monitor::Command Monitor::commands[] = {
    {"DO", 2, &Monitor::do_instruction,
     "DO instruction          carries out a program instruction, waits for its end"},
    {"SPEED", 2, &Monitor::monitor_speed, "SPEED per cent          of all motions"},
    {"EXECUTE", 2, &Monitor::execute, "EXECUTE program, count  starts it; count below 0 repeats it for ever"},
    {"EDIT", 2, &Monitor::edit,
     "EDIT program            shows its steps, takes others; E ends, D deletes, I inserts"},
    {"ABORT", 2, &Monitor::abort, "ABORT                   stops the arm and the program, closes ALTER"},
    {"PCABORT", 3, &Monitor::abort_process,
     "PCABORT                 stops the process control program (there is none)"},
    {"BASE", 2, &Monitor::base, "BASE dx, dy, dz, turn   of all locations"},
    {"TOOL", 2, &Monitor::tool, "TOOL location           of the tip from the flange; none: the flange"},
    {"WHERE", 2, &Monitor::where, "WHERE                   where the tip and the joints are"},
    {"POINT", 2, &Monitor::point, "POINT location          shows and changes a location"},
    {"HERE", 2, &Monitor::here, "HERE location           teaches where the tip is, then as POINT"},
    {"CALIBRATE", 2, &Monitor::calibrate, "CALIBRATE               clears a fault of the arm"},
    {"STATUS", 2, &Monitor::status, "STATUS                  speed, program, ALTER, fault"},
    {"LISTL", 5, &Monitor::list_locations, "LISTL                   locations"},
    {"LISTR", 5, &Monitor::list_reals, "LISTR                   numbers"},
    {"LISTP", 5, &Monitor::list_programs, "LISTP                   programs"},
    {"DELETEL", 7, &Monitor::delete_locations, "DELETEL location, ...   forgets locations"},
    {"HELP", 2, &Monitor::help, "HELP                    this"}};

void Monitor::command(Line line, const std::string& word) {
  if (set_configuration(machine_, word)) return line.end();
  for (const Command& known : commands) {
    if (word.size() < known.shortest || !std::string(known.word).starts_with(word)) continue;
    return (this->*known.carry_out)(line);
  }
  throw Error("Unknown command", word);
}

void Monitor::monitor_speed(Line& line) {
  const double percent = number(line, machine_.values());
  line.end();
  if (percent <= 0 || percent > 100) throw Error("Illegal speed", "above 0 to 100 is wanted");
  machine_.monitor_speed = percent;
}

void Monitor::execute(Line& line) {
  const std::string name = line.name();
  long count = 1;
  line.take(',');
  constexpr long most = 32767;
  if (!line.done()) count = whole_number(line, machine_.values(), -most, most);
  line.end();
  const auto found = machine_.store.programs.find(name);
  if (found == machine_.store.programs.end()) throw Error("Undefined program", name);
  if (found->second.empty()) throw Error("Empty program", name);
  if (program_) throw Error("Program is running", program_->name);
  if (count == 0) return;
  program_.emplace(name, found->second, count, Instruction(machine_, true));
  machine_.attached = true;
  program_next_ = machine_.timeline.after(options_.thinking, [this] { step_program(); });
}

void Monitor::abort(Line& line) {
  line.end();
  if (machine_.alter != nullptr && machine_.alter->is_open()) machine_.alter->close();
  std::string shown;
  if (program_) {
    shown = "Stopped " + program_->name + " at step " + std::to_string(program_->step + 1) + "\r\n";
    machine_.timeline.cancel(program_next_);
    machine_.attached = false;
    program_.reset();
  }
  stop(shown);
}

void Monitor::abort_process(Line& line) {
  line.end();
}

void Monitor::base(Line& line) {
  set_base(machine_, line);
}

void Monitor::tool(Line& line) {
  set_tool(machine_, line);
}

void Monitor::where(Line& line) {
  line.end();
  const Joints q = machine_.arm.joints();
  shown_ =
      "    X        Y        Z        O        A        T\r\n" + columns(shown_figures(machine_.here(q))) +
      "\r\n   JT1      JT2      JT3      JT4      JT5      JT6\r\n" + joint_columns(val_joints(q)) + "\r\n";
}

void Monitor::point(Line& line) {
  const std::string name = line.name();
  line.end();
  ask_location(name);
}

void Monitor::here(Line& line) {
  const std::string name = line.name();
  line.end();
  machine_.store.locations[name] = machine_.here(machine_.arm.joints());
  ask_location(name);
}

void Monitor::calibrate(Line& line) {
  line.end();
  const std::string problem = machine_.arm.clear_fault();
  if (!problem.empty()) throw Error("Arm fault", problem);
}

void Monitor::status(Line& line) {
  line.end();
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "Monitor speed %.4g  program speed %.4g%s\r\n",
                machine_.monitor_speed,
                machine_.program_speed.straight.value_or(machine_.program_speed.percent),
                machine_.program_speed.straight ? " mm/s" : "");
  shown_ = text.data();
  shown_ += program_ ? program_->name + " runs, step " + std::to_string(program_->step + 1)
                     : std::string("No program runs");
  shown_ += "\r\nALTER is ";
  shown_ += machine_.alter == nullptr ? "not there" : machine_.alter->is_open() ? "open" : "closed";
  shown_ += "\r\n" + to_string(configuration_of(machine_.arm.joints())) + "\r\n";
  const std::string fault = machine_.arm.fault();
  if (!fault.empty()) throw Error("Arm fault", fault);
}

void Monitor::list_locations(Line& line) {
  line.end();
  for (const auto& [name, place] : machine_.store.locations) {
    std::array<char, 32> padded{};
    std::snprintf(padded.data(), padded.size(), "%-20s", name.c_str());
    shown_ += padded.data() + columns(shown_figures(place)) + "\r\n";
  }
}

void Monitor::list_reals(Line& line) {
  line.end();
  for (const auto& [name, value] : machine_.store.reals) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%-20s %.8g\r\n", name.c_str(), value);
    shown_ += text.data();
  }
}

void Monitor::list_programs(Line& line) {
  line.end();
  for (const auto& [name, lines] : machine_.store.programs) {
    shown_ += " .PROGRAM " + name + "\r\n";
    for (std::size_t i = 0; i < lines.size(); ++i)
      shown_ += "   " + std::to_string(i + 1) + "  " + lines[i] + "\r\n";
    shown_ += " .END\r\n";
  }
}

void Monitor::delete_locations(Line& line) {
  do {
    const std::string name = line.name();
    if (machine_.store.locations.erase(name) == 0) throw Error("Undefined value", name);
  } while (line.take(','));
  line.end();
}

void Monitor::edit(Line& line) {
  edited_ = line.name();
  line.end();
  if (program_ && program_->name == edited_) throw Error("Program is running", edited_);
  edited_step_ = 0;
  state_ = State::editing;
  output_(" .PROGRAM " + edited_ + "\r\n");
  ask_step();
}

void Monitor::help(Line& line) {
  line.end();
  for (const Command& known : commands) shown_ += std::string(known.use) + "\r\n";
  shown_ +=
      "RIGHTY LEFTY ABOVE BELOW FLIP NOFLIP: of the next MOVE\r\n"
      "DO: MOVE MOVES APPRO APPROS DEPART DEPARTS DRIVE READY DELAY OPENI CLOSEI\r\n"
      "    SPEED SET HERE BASE TOOL ALTER NOALTER TYPE, name = number\r\n";
}

}  // namespace pal::sim::val
