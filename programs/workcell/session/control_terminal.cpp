#include "programs/workcell/session/control_terminal.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <ostream>
#include <sstream>

namespace pal::workcell {
namespace {

constexpr int look_each_ms = 20;
constexpr const char* help =
    "step [COUNT]       go on for COUNT statements, 1 if not given\n"
    "go                 go on\n"
    "pause              hold the run\n"
    "break MODULE:LINE  hold it when the statement is about to have its effect; or FILE:LINE\n"
    "clear              forget the breakpoints\n"
    "where              say where each thread is\n"
    "stop               end the skill\n";

/// A positive whole number, or 0.
int number(const std::string& text) {
  int value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  return problem == std::errc() && end == text.data() + text.size() && value > 0 ? value : 0;
}

bool is_named(const runtime::StatementSpec& statement, const std::string& where) {
  const std::string_view file = statement.file;
  return where == statement.module || where == file || where == file.substr(file.rfind('/') + 1);
}

}  // namespace

ControlTerminal::ControlTerminal(runtime::RunControl& control, const runtime::Wiring& wiring, int input,
                                 std::ostream& out)
    : control_(control), wiring_(wiring), input_(input), out_(out) {
  control_.pause();
  reader_ = std::thread([this] { serve(); });
}

ControlTerminal::~ControlTerminal() {
  over_ = true;
  reader_.join();
}

// One command at a time: the next one is read when the run is held, so that a script does what it says.
void ControlTerminal::serve() {
  std::string text;
  bool open = true;
  while (!over_) {
    if (waiting_ && control_.wait_for_halt(std::chrono::milliseconds(look_each_ms))) {
      waiting_ = false;
      say_where();
    }
    const std::size_t end = text.find('\n');
    // While it runs only what holds or ends it is obeyed at once.
    const std::string_view first = std::string_view(text).substr(0, end);
    if (end != std::string::npos && (!waiting_ || first == "pause" || first == "stop")) {
      const std::string line = text.substr(0, end);
      text.erase(0, end + 1);
      obey(line);
      continue;
    }
    if (!open) {
      if (!waiting_ && text.empty()) {
        control_.clear_breakpoints();
        control_.resume();
        return;
      }
      continue;
    }
    pollfd ready{input_, POLLIN, 0};
    if (::poll(&ready, 1, waiting_ ? 0 : look_each_ms) <= 0) continue;
    std::array<char, 512> buffer{};
    const ssize_t count = ::read(input_, buffer.data(), buffer.size());
    if (count > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(count));
    } else {
      open = false;
      if (!text.empty() && text.back() != '\n') text += '\n';
    }
  }
}

void ControlTerminal::obey(const std::string& line) {
  std::istringstream words(line);
  std::string command, argument, more;
  words >> command >> argument >> more;
  if (!more.empty()) {
    out_ << "'" << more << "' is too much\n" << help << std::flush;
  } else if (command == "step" && (argument.empty() || number(argument) > 0)) {
    control_.step(argument.empty() ? 1 : static_cast<std::size_t>(number(argument)));
    waiting_ = true;
  } else if (command == "go") {
    control_.resume();
    waiting_ = true;
  } else if (command == "pause") {
    control_.pause();
    waiting_ = true;
  } else if (command == "stop") {
    control_.stop();
    waiting_ = true;
  } else if (command == "clear") {
    control_.clear_breakpoints();
  } else if (command == "where") {
    say_where();
  } else if (command == "break") {
    break_at(argument);
  } else if (!command.empty()) {
    out_ << help << std::flush;
  }
}

void ControlTerminal::break_at(const std::string& place) {
  const std::size_t colon = place.rfind(':');
  const std::string where = place.substr(0, colon);
  const int line = colon == std::string::npos ? 0 : number(place.substr(colon + 1));
  std::string lines;
  for (const runtime::StatementSpec& statement : wiring_.statements) {
    if (!is_named(statement, where)) continue;
    if (statement.line == line) {
      control_.break_at(where, line);
      out_ << "breakpoint at " << place << ": " << statement.text << std::endl;
      return;
    }
    lines += " " + std::to_string(statement.line);
  }
  out_ << "no statement at '" << place << "'; "
       << (lines.empty() ? "name a module or a file, and a line: break SM1:51"
                         : where + " has statements in lines" + lines)
       << std::endl;
}

void ControlTerminal::say_where() {
  const auto halt = control_.wait_for_halt(std::chrono::milliseconds(0));
  if (!halt) return;
  out_ << fmt::format("{} at {:.6f} ms{}\n", halt->reason, static_cast<double>(halt->time.count()) / 1e6,
                      halt->next.empty() ? "" : ", before " + halt->next);
  for (const std::string& thread : halt->threads) out_ << "  " << thread << '\n';
  out_ << std::flush;
}

}  // namespace pal::workcell
