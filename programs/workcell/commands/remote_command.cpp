// workcell operation at a server: run, step, pause, stop, resume, state, watch.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>

#include "operations/load.hpp"
#include "operations/step_log.hpp"
#include "pal/runtime/run_control.hpp"
#include "pal/support/text_width.hpp"
#include "programs/workcell/commands/refused_operation.hpp"
#include "programs/workcell/options/command_line.hpp"
#include "programs/workcell/session/interrupt.hpp"
#include "server/announcement.hpp"
#include "server/client.hpp"

namespace pal::workcell {
namespace {

using Json = nlohmann::ordered_json;
using namespace std::chrono_literals;

/// The operation with the files of its sub-operations, by their names. The server does not read our files.
std::string files_of(const std::string& main, std::ostream& error) {
  SourceManager sources;
  Diagnostics diagnostics;
  const auto program = operations::load(DiskFileSystem(), sources, main, diagnostics);
  if (!program || diagnostics.has_errors()) throw refused_operation(main, diagnostics, sources, error);
  Json json{{"main", main}, {"files", Json::object()}};
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const FileId file(i);
    json["files"][sources.name(file)] = std::string(sources.text(file));
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string halt_of(const Json& state) {
  return operations::told(state.value("state", ""), state.value("token", ""),
                          state.value("steps", std::size_t{0}), state.value("reason", ""));
}

/// The announcement of the one server that there is.
std::string the_server() {
  const std::vector<std::string> found = server::announced_servers();
  if (found.size() == 1) return found.front();
  if (found.empty())
    throw Failure(ExitStatus::usage, "server", "no server is there",
                  "start one with 'workcell serve', or name its file: --at FILE");
  throw Failure(ExitStatus::usage, "server", fmt::format("{} servers are there", found.size()),
                fmt::format("name one: --at {}", fmt::join(found, " or --at ")));
}

/// One connection: what the person asked for, and what is told of it.
class Terminal {
 public:
  Terminal(const RemoteCommand& command, std::ostream& out) : out_(out) {
    const std::string path = command.announcement.empty() ? the_server() : command.announcement;
    try {
      const auto announced = server::read_announcement(path);
      client_.emplace(announced.address, announced.port);
      const Json hello{{"token", announced.tokens.programmer},
                       {"name", fmt::format("workcell operation {}", command.verb)}};
      state_ = call("hello", hello.dump());
    } catch (const std::exception& problem) {
      throw Failure(ExitStatus::usage, "server", problem.what(),
                    "start one with 'workcell serve', or name its file: --at FILE");
    }
    if (!command.log.empty()) {
      log_.open(command.log, std::ios::binary);
      if (!log_) throw Failure(ExitStatus::usage, "--log " + command.log, "it cannot be written");
    }
  }

  Json call(const std::string& method, const std::string& parameters = "{}") {
    return Json::parse(client_->call(method, parameters));
  }
  /// Whether nothing ran when this terminal said hello.
  bool idle() const { return text("activity") == "idle"; }

  /// Asks for it, and tells what happens until the operation halts. Ctrl-C stops it.
  ExitStatus follow(const std::string& method) {
    call("watch");
    call(method);
    return tell_until_it_halts();
  }
  /// Tells what happens, until Ctrl-C.
  ExitStatus watch() {
    runtime::RunControl control;
    const Interrupt interrupt(control);
    call("watch", R"({"since": 0})");
    while (!control.stopping()) {
      const auto text = client_->next(200ms);
      if (text) tell(Json::parse(*text));
    }
    return ExitStatus::done;
  }

  void tell_state() {
    const std::string operation = text("operation").empty()
                                      ? "no operation is loaded"
                                      : fmt::format("operation {}: {}; last code {}", text("operation"),
                                                    halt_of(state_), state_.value("last_code", 0));
    say(fmt::format("cell {}: {}; {}; controls: {}", text("cell"), text("activity"), operation,
                    text("controls", "free")));
  }

 private:
  std::string text(const char* field, const char* otherwise = "") const {
    const std::string found = state_.value(field, std::string());
    return found.empty() ? otherwise : found;
  }
  ExitStatus tell_until_it_halts() {
    runtime::RunControl control;
    const Interrupt interrupt(control);
    bool asked = false;
    for (;;) {
      if (control.stopping() && !std::exchange(asked, true)) call("operation.stop");
      const auto received = client_->next(200ms);
      if (!received) continue;
      const Json event = Json::parse(*received);
      tell(event);
      const Json& params = event["params"];
      if (params.value("event", "") != "state" || params.value("state", "") == "running") continue;
      const std::string state = params.value("state", "");
      if (state == "stopped")
        out_ << "  'resume' begins it again; 'from ICON' puts the token elsewhere\n" << std::flush;
      using operations::ExecutionState;
      return status_of(state == "failed" || state == "stopped" ? ExecutionState::failed
                       : state == "ended"                      ? ExecutionState::ended
                                                               : ExecutionState::paused,
                       params.value("last_code", 0));
    }
  }
  void tell(const Json& message) {
    if (message.value("method", "") != "event") return;
    Json event = message["params"];
    const std::string kind = event.value("event", "");
    if (kind == "ends") {
      tell_step(event);
    } else if (kind == "state" && event.value("state", "") != "running") {
      say(halt_of(event));
    } else if (kind == "loaded") {
      say(fmt::format("operation {}", event.value("operation", "")));
    }
  }
  /// Names come from files of others, and some characters command a terminal.
  void say(const std::string& text) { out_ << printable(text) << '\n' << std::flush; }
  void tell_step(Json step) {
    if (const auto parsed = operations::parse_log_line(step.dump())) say(operations::told(*parsed));
    if (!log_.is_open()) return;
    for (const char* ours : {"number", "time_s", "event"}) step.erase(ours);
    log_ << step.dump() << '\n' << std::flush;
  }

  std::ostream& out_;
  std::optional<server::Client> client_;
  std::ofstream log_;
  Json state_;
};

void set_breakpoint(const std::string& text, Terminal& terminal) {
  const operations::Breakpoint breakpoint = breakpoint_of(text);
  Json json{{"icon", breakpoint.icon}};
  if (breakpoint.code) json["code"] = *breakpoint.code;
  terminal.call("operation.break", json.dump());
}

/// True: the command changes the operation and runs nothing.
bool change(const RemoteCommand& command, Terminal& terminal) {
  const std::vector<std::string>& words = command.arguments;
  if (command.verb == "set") {
    const operations::Value value = operations::parse_value(words[2]);
    Json json{{"icon", words[0]}, {"parameter", words[1]}};
    std::visit([&](const auto& each) { json["value"] = each; }, value);
    terminal.call("operation.set", json.dump());
  } else if (command.verb == "break") {
    set_breakpoint(words[0], terminal);
  } else if (command.verb == "from") {
    terminal.call("operation.from", Json{{"icon", words[0]}}.dump());
  } else if (command.verb == "clear") {
    terminal.call("operation.clear");
  } else {
    return false;
  }
  return true;
}

ExitStatus obey(const RemoteCommand& command, Terminal& terminal, std::ostream& out, std::ostream& error) {
  if (command.verb == "state") {
    terminal.tell_state();
    return ExitStatus::done;
  }
  if (command.verb == "watch") return terminal.watch();
  if (command.verb == "stop" || command.verb == "pause") {
    terminal.call("operation." + command.verb);
    if (command.verb == "pause") {
      out << "told to pause after the current skill\n";
    } else {
      out << (terminal.idle() ? "nothing was running\n" : "told to stop\n");
    }
    return ExitStatus::done;
  }
  if (!command.file.empty()) terminal.call("operation.load", files_of(command.file, error));
  if (command.verb == "load") {
    out << "loaded; 'workcell operation run' runs it, 'step' one step of it\n";
    return ExitStatus::done;
  }
  if (change(command, terminal)) {
    out << "done\n";
    return ExitStatus::done;
  }
  for (const std::string& text : command.breakpoints) set_breakpoint(text, terminal);
  if (!command.from.empty()) terminal.call("operation.from", Json{{"icon", command.from}}.dump());
  if (command.verb == "run" && command.detach) {
    terminal.call("operation.run");
    terminal.call("controls.release");
    out << "it runs; 'workcell operation watch' tells what happens\n";
    return ExitStatus::done;
  }
  return terminal.follow("operation." + command.verb);
}

}  // namespace

ExitStatus command_server(const RemoteCommand& command, std::ostream& out, std::ostream& error) {
  Terminal terminal(command, out);
  try {
    return obey(command, terminal, out, error);
  } catch (const server::RemoteError& problem) {
    throw Failure(ExitStatus::wrong_specification, "server", problem.what());
  } catch (const Failure&) {
    throw;
  } catch (const std::exception& problem) {
    throw Failure(ExitStatus::error_completion, "server", problem.what());
  }
}

}  // namespace pal::workcell
