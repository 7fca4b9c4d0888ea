// workcell operation run: an operation in a workcell of its own.
#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>
#include <ostream>

#include "operations/debugger.hpp"
#include "operations/load.hpp"
#include "operations/step_log.hpp"
#include "programs/workcell/commands/refused_operation.hpp"
#include "programs/workcell/options/command_line.hpp"
#include "programs/workcell/session/cell_runner.hpp"
#include "programs/workcell/session/fault_file.hpp"
#include "programs/workcell/session/person.hpp"

namespace pal::workcell {
namespace {

using operations::ExecutionState;

using Check = std::function<void(const operations::Program&, Diagnostics&)>;

/// Without what would end or upset it halfway. Warnings are for `pal operation check`.
operations::Program checked_program(const std::string& file, const std::vector<Check>& checks,
                                    std::ostream& error) {
  SourceManager sources;
  Diagnostics diagnostics;
  auto program = operations::load(DiskFileSystem(), sources, file, diagnostics);
  for (const Check& check : checks)
    if (program && !diagnostics.has_errors()) check(*program, diagnostics);
  if (program && !diagnostics.has_errors()) return std::move(*program);
  throw refused_operation(file, diagnostics, sources, error);
}

/// A line a step for people, and the log.
class Onlooker final : public operations::StepObserver {
 public:
  Onlooker(std::ostream& out, std::ostream* log) : out_(out) {
    if (log != nullptr) log_.emplace(*log);
  }
  void done(const operations::Step& step) override {
    out_ << operations::told(step) << '\n';
    if (log_) log_->done(step);
  }

 private:
  std::ostream& out_;
  std::optional<operations::StepLog> log_;
};

ExitStatus execute(const OperationCommand& command, operations::Executor& executor, std::istream* in,
                   std::ostream& out) {
  for (const std::string& text : command.breakpoints) executor.add_breakpoint(breakpoint_of(text));
  if (!command.from.empty()) executor.start_from(command.from);
  if (command.interactive && in != nullptr) {
    executor.add_kept_breakpoints(std::numeric_limits<std::size_t>::max());
    operations::debug(executor, *in, out);
  } else if (command.steps > 0) {
    executor.run(command.steps);
  } else {
    executor.run();
  }
  out << fmt::format("operation {}: {}\n", executor.program().operations.front().name,
                     operations::told(operations::name(executor.state()), executor.token(), executor.steps(),
                                      executor.reason()));
  return status_of(executor.state(), executor.last_code());
}

}  // namespace

ExitStatus status_of(ExecutionState state, int code) {
  if (state == ExecutionState::failed || state == ExecutionState::stopped)
    return ExitStatus::error_completion;
  if (state != ExecutionState::ended || code == 0) return ExitStatus::done;
  constexpr int of_exits = 100, greatest = 99;
  return static_cast<ExitStatus>(of_exits + (code > 0 && code <= greatest ? code : 0));
}

operations::Breakpoint breakpoint_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return {text, {}};
  int code = 0;
  const auto [end, problem] = std::from_chars(text.data() + equals + 1, text.data() + text.size(), code);
  if (problem != std::errc() || end != text.data() + text.size())
    throw Failure(ExitStatus::usage, "breakpoint " + text, "what follows the '=' is no completion code",
                  "write ICON or ICON=CODE");
  return {text.substr(0, equals), code};
}

runtime::CostPolicy times_named(const std::string& name) {
  if (name == "worst") return runtime::CostPolicy::worst;
  return name == "best" ? runtime::CostPolicy::best : runtime::CostPolicy::random;
}

ExitStatus run_operation(const OperationCommand& command, const std::vector<KnownSkill>& known,
                         std::istream* in, std::ostream& out, std::ostream& error) {
  const sim::Scene scene =
      sim::find_scene(command.scene, {command.scene_folders.begin(), command.scene_folders.end()});
  const runtime::CostPolicy times = times_named(command.times);
  sim::CellOptions options;
  options.seed = command.seed;
  options.times = times;
  options.faults = faults_of_lines(command.faults);
  std::optional<sim::Cell> cell;
  operations::Cell known_of_cell;
  operations::Program program = checked_program(
      command.file,
      {[](const auto& each, auto& diagnostics) { operations::check_shape(each, diagnostics); },
       [&](const auto& each, auto& diagnostics) {
         try {
           cell.emplace(scene, options);
         } catch (const sim::NoSuchDevice& problem) {
           throw no_such_device(command.faults, problem);
         }
         known_of_cell = cell_of(*cell, known, scene, command.scene_folders);
         operations::check_cell(each, known_of_cell, diagnostics);
       }},
      error);
  std::ofstream log;
  if (!command.log.empty()) {
    log.open(command.log, std::ios::binary);
    if (!log) throw Failure(ExitStatus::usage, "--log " + command.log, "it cannot be written");
  }
  CellRunner runner(*cell, known, times, command.seed);
  runner.on_broken_promise(policy_named(command.on_broken_promise));
  PersonAtTerminal person(command.answers, in, out);
  runner.let_answer(&person);
  Onlooker onlooker(out, command.log.empty() ? nullptr : &log);
  operations::Executor executor(std::move(program), runner, &onlooker, &known_of_cell);
  try {
    const ExitStatus status = execute(command, executor, in, out);
    const bool untried =
        tell_faults_to_come(command.faults, cell->faults_to_come(), "the operation ended before", out);
    return untried && status == ExitStatus::done ? ExitStatus::wrong_specification : status;
  } catch (const operations::ExecutionError& problem) {
    throw Failure(ExitStatus::wrong_specification, command.file, problem.what(),
                  "workcell operation run FILE --step, then list, shows the icons");
  }
}

}  // namespace pal::workcell
