#include "operations/debugger.hpp"

#include <fmt/format.h>

#include <charconv>
#include <istream>
#include <ostream>
#include <sstream>

#include "operations/step_log.hpp"

namespace pal::operations {
namespace {

constexpr const char* help =
    "step                      one line of the log: a skill, a delay, a wait, a test, a question or a zero\n"
    "run                       until the end, a breakpoint or Ctrl-C; also goes on after these\n"
    "set ICON PARAMETER VALUE  from the icon's next run on; shows the new value and the one before\n"
    "break ICON [CODE]         halt before the icon, with a code only if that came last\n"
    "break                     the breakpoints\n"
    "clear                     forget all breakpoints\n"
    "from ICON                 put the token before an icon\n"
    "where                     where the token is\n"
    "list                      the icons\n"
    "quit\n";

bool parse_number(const std::string& text, double& value) {
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  return problem == std::errc() && end == text.data() + text.size();
}

constexpr std::size_t most_listed = 500;

/// Sub-operations that contain others can be very many icons: `left` counts down those that are still shown.
void list(const Program& program, std::size_t operation, const std::string& prefix, std::size_t& left,
          std::ostream& out) {
  const Operation& shown = program.operations[operation];
  for (const Icon& icon : shown.icons) {
    if (left == 0) return;
    if (--left == 0) {
      out << "  … and more\n";
      return;
    }
    out << fmt::format("  {}{}  {}", prefix, icon.id, name(icon.kind));
    if (!icon.skill.empty() && icon.skill != icon.id) out << ' ' << icon.skill;
    if (const std::string what = subjects_text(icon); !what.empty()) out << " of " << what;
    for (const Parameter& parameter : icon.parameters)
      out << fmt::format("  {}={}", parameter.name, to_text(parameter));
    out << '\n';
    if (icon.kind != IconKind::sub_operation) continue;
    if (const auto sub = find_sub_operation(program, shown, icon))
      list(program, *sub, prefix + icon.id + "/", left, out);
  }
}

void where(const Executor& executor, std::ostream& out) {
  out << fmt::format("{}; last code {}\n",
                     told(name(executor.state()), executor.token(), executor.steps(), executor.reason()),
                     executor.last_code());
}

void list_breakpoints(const Executor& executor, std::ostream& out) {
  if (executor.breakpoints().empty()) out << "no breakpoints\n";
  for (const Breakpoint& each : executor.breakpoints())
    out << fmt::format("  break {}{}\n", each.icon, each.code ? fmt::format(" {}", *each.code) : "");
}

/// Sets it, and tells what it was.
void set(Executor& executor, const std::string& icon, const std::string& parameter, const std::string& value,
         std::ostream& out) {
  const auto before = executor.parameter(icon, parameter);
  executor.set_parameter(icon, parameter, parse_value(value));
  out << fmt::format("{}: {} is {} now, before it was {}\n", icon, parameter,
                     to_text(executor.parameter(icon, parameter)->value),
                     before ? to_text(*before) : std::string("the default"));
}

/// False: the line asked to quit.
bool obey(Executor& executor, const std::string& line, std::ostream& out) {
  std::istringstream words(line);
  std::string command, icon, second;
  words >> command;
  if (command.empty()) return true;
  if (command == "quit") return false;
  words >> icon;
  if (command == "step") {
    executor.step();
  } else if (command == "run") {
    executor.run();
  } else if (command == "set") {
    words >> second >> std::ws;
    std::string value;
    std::getline(words, value);
    if (value.empty()) throw ExecutionError("write set ICON PARAMETER VALUE");
    set(executor, icon, second, value, out);
  } else if (command == "break" && icon.empty()) {
    list_breakpoints(executor, out);
    return true;
  } else if (command == "break") {
    Breakpoint breakpoint{icon, {}};
    double code = 0;
    if (words >> second) {
      if (!parse_number(second, code)) throw ExecutionError("'" + second + "' is no completion code");
      breakpoint.code = static_cast<int>(code);
    }
    executor.add_breakpoint(breakpoint);
    list_breakpoints(executor, out);
  } else if (command == "clear") {
    executor.clear_breakpoints();
  } else if (command == "from") {
    executor.start_from(icon);
  } else if (command == "list") {
    std::size_t left = most_listed;
    list(executor.program(), 0, "", left, out);
    return true;
  } else if (command == "help") {
    out << help;
    return true;
  } else if (command != "where") {
    throw ExecutionError("there is no command '" + command + "'; help shows those that there are");
  }
  where(executor, out);
  return true;
}

}  // namespace

void debug(Executor& executor, std::istream& in, std::ostream& out) {
  where(executor, out);
  for (std::string line; std::getline(in, line);) {
    try {
      if (!obey(executor, line, out)) return;
    } catch (const ExecutionError& problem) {
      out << "error: " << problem.what() << '\n';
    }
  }
}

}  // namespace pal::operations
