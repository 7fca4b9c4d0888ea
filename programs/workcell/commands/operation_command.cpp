// workcell operation run: an operation in a workcell of its own.
#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <functional>
#include <optional>
#include <ostream>
#include <set>

#include "operations/debugger.hpp"
#include "operations/load.hpp"
#include "operations/step_log.hpp"
#include "programs/workcell/commands/refused_operation.hpp"
#include "programs/workcell/options/command_line.hpp"
#include "programs/workcell/session/cell_runner.hpp"
#include "programs/workcell/session/fault_file.hpp"
#include "programs/workcell/session/needed_tool.hpp"

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

void check_tools(const operations::Program& program, const std::vector<KnownSkill>& known,
                 const sim::Scene& scene, const std::vector<std::string>& folders) {
  const std::set<std::string> needed = operations::skills_of(program);
  for (const KnownSkill& skill : known)
    if (needed.contains(skill.name)) check_tool(*skill.make(), scene, folders);
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
    operations::debug(executor, *in, out);
  } else if (command.steps > 0) {
    executor.run(command.steps);
  } else {
    executor.run();
  }
  out << fmt::format("operation {}: {}\n", executor.program().operations.front().name,
                     operations::told(operations::name(executor.state()), executor.token(), executor.steps(),
                                      executor.reason()));
  const bool well = executor.state() != ExecutionState::failed && executor.state() != ExecutionState::stopped;
  return well ? ExitStatus::done : ExitStatus::error_completion;
}

}  // namespace

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
  const operations::Skills skills = templates_of(known);
  const sim::Scene scene =
      sim::find_scene(command.scene, {command.scene_folders.begin(), command.scene_folders.end()});
  const runtime::CostPolicy times = times_named(command.times);
  sim::CellOptions options;
  options.seed = command.seed;
  options.times = times;
  options.faults = faults_of_lines(command.faults);
  std::optional<sim::Cell> cell;
  operations::Program program =
      checked_program(command.file,
                      {operations::check_shape,
                       [&](const auto& each, auto& diagnostics) {
                         operations::check_skills(each, skills, std::nullopt, diagnostics);
                       },
                       [&](const auto& each, auto& diagnostics) {
                         check_tools(each, known, scene, command.scene_folders);
                         try {
                           cell.emplace(scene, options);
                         } catch (const sim::NoSuchDevice& problem) {
                           throw no_such_device(command.faults, problem);
                         }
                         operations::check_skills(each, skills, locations_of(*cell), diagnostics);
                         operations::check_sensors(each, sensors_of(*cell), diagnostics);
                       }},
                      error);
  std::ofstream log;
  if (!command.log.empty()) {
    log.open(command.log, std::ios::binary);
    if (!log) throw Failure(ExitStatus::usage, "--log " + command.log, "it cannot be written");
  }
  CellRunner runner(*cell, known, times, command.seed);
  runner.on_broken_promise(policy_named(command.on_broken_promise));
  Onlooker onlooker(out, command.log.empty() ? nullptr : &log);
  operations::Executor executor(std::move(program), runner, &onlooker, &skills);
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
