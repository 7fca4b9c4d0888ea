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
    "step                      one skill, delay, wait or test\n"
    "run                       until the end, a breakpoint or Ctrl-C; also goes on after these\n"
    "set ICON PARAMETER VALUE  from the icon's next run on\n"
    "break ICON [CODE]         halt before the icon, with a code only if that came last\n"
    "clear                     forget all breakpoints\n"
    "from ICON                 put the token before an icon\n"
    "where                     where the token is\n"
    "list                      the icons\n"
    "quit\n";

bool parse_number(const std::string& text, double& value) {
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  return problem == std::errc() && end == text.data() + text.size();
}

void list(const Program& program, std::size_t operation, const std::string& prefix, std::ostream& out) {
  const Operation& shown = program.operations[operation];
  for (const Icon& icon : shown.icons) {
    out << fmt::format("  {}{}  {}", prefix, icon.id, name(icon.kind));
    if (!icon.skill.empty() && icon.skill != icon.id) out << ' ' << icon.skill;
    if (!icon.sensor.empty()) out << " of " << icon.sensor;
    for (const Parameter& parameter : icon.parameters)
      out << fmt::format("  {}={}", parameter.name, to_text(parameter));
    out << '\n';
    if (icon.kind != IconKind::sub_operation) continue;
    if (const auto sub = find_sub_operation(program, shown, icon))
      list(program, *sub, prefix + icon.id + "/", out);
  }
}

void where(const Executor& executor, std::ostream& out) {
  out << fmt::format("{}; last code {}\n",
                     told(name(executor.state()), executor.token(), executor.steps(), executor.reason()),
                     executor.last_code());
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
    executor.set_parameter(icon, second, parse_value(value));
  } else if (command == "break") {
    Breakpoint breakpoint{icon, {}};
    double code = 0;
    if (words >> second) {
      if (!parse_number(second, code)) throw ExecutionError("'" + second + "' is no completion code");
      breakpoint.code = static_cast<int>(code);
    }
    executor.add_breakpoint(breakpoint);
  } else if (command == "clear") {
    executor.clear_breakpoints();
  } else if (command == "from") {
    executor.start_from(icon);
  } else if (command == "list") {
    list(executor.program(), 0, "", out);
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
