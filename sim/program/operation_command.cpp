#include <fmt/format.h>

#include <fstream>
#include <ostream>

#include "operations/debugger.hpp"
#include "operations/load.hpp"
#include "operations/step_log.hpp"
#include "pal/support/render.hpp"
#include "sim/program/cell_runner.hpp"
#include "sim/program/command_line.hpp"

namespace pal::workcell {
namespace {

using operations::ExecutionState;

/// Without what would end or upset it halfway. Warnings are for `pal operation check`.
operations::Program checked_program(const OperationCommand& command, const operations::Skills& skills,
                                    std::ostream& error) {
  SourceManager sources;
  Diagnostics diagnostics;
  auto program = operations::load(DiskFileSystem(), sources, command.file, diagnostics);
  if (program && !diagnostics.has_errors()) operations::check_shape(*program, diagnostics);
  if (program && !diagnostics.has_errors())
    operations::check_skills(*program, skills, std::nullopt, diagnostics);
  if (program && !diagnostics.has_errors()) return std::move(*program);
  render_text(diagnostics.sorted(), sources, error);
  const bool unreadable = sources.size() == 0;
  throw Failure(unreadable ? ExitStatus::usage : ExitStatus::wrong_specification, command.file,
                unreadable ? "it cannot be read" : "the operation has errors, so nothing moved",
                "pal operation check shows them all");
}

/// A line a step for people, and the log.
class Onlooker final : public operations::StepObserver {
 public:
  Onlooker(std::ostream& out, std::ostream* log) : out_(out) {
    if (log != nullptr) log_.emplace(*log);
  }
  void done(const operations::Step& step) override {
    const double seconds = static_cast<double>((step.end - step.begin).count()) / 1e9;
    if (step.skill.empty()) {
      out_ << fmt::format("{:4}  {}: waited {:.3f} s\n", step.number, step.icon, seconds);
    } else {
      out_ << fmt::format("{:4}  {}: {} ended with code {} after {:.3f} s: {}\n", step.number, step.icon,
                          step.skill, step.result.code, seconds, step.result.reason);
    }
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
  out << fmt::format("operation {}: {} after {} steps{}{}\n", executor.program().operations.front().name,
                     operations::name(executor.state()), executor.steps(),
                     executor.reason().empty() ? "" : ": ", executor.reason());
  const bool well = executor.state() != ExecutionState::failed && executor.state() != ExecutionState::stopped;
  return well ? ExitStatus::done : ExitStatus::error_completion;
}

}  // namespace

operations::Breakpoint breakpoint_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return {text, {}};
  try {
    return {text.substr(0, equals), std::stoi(text.substr(equals + 1))};
  } catch (const std::exception&) {
    throw Failure(ExitStatus::usage, "--break " + text, "what follows the '=' is no completion code",
                  "write ICON or ICON=CODE");
  }
}

runtime::CostPolicy times_named(const std::string& name) {
  if (name == "worst") return runtime::CostPolicy::worst;
  return name == "best" ? runtime::CostPolicy::best : runtime::CostPolicy::random;
}

ExitStatus run_operation(const OperationCommand& command, const std::vector<KnownSkill>& known,
                         std::istream* in, std::ostream& out, std::ostream& error) {
  const operations::Skills skills = templates_of(known);
  operations::Program program = checked_program(command, skills, error);
  std::ofstream log;
  if (!command.log.empty()) {
    log.open(command.log, std::ios::binary);
    if (!log) throw Failure(ExitStatus::usage, "--log " + command.log, "it cannot be written");
  }
  const sim::Scene scene =
      sim::find_scene(command.scene, {command.scene_folders.begin(), command.scene_folders.end()});
  const runtime::CostPolicy times = times_named(command.times);
  sim::CellOptions options;
  options.seed = command.seed;
  options.times = times;
  sim::Cell cell(scene, options);
  CellRunner runner(cell, known, times, command.seed);
  Onlooker onlooker(out, command.log.empty() ? nullptr : &log);
  operations::Executor executor(std::move(program), runner, &onlooker, &skills);
  try {
    return execute(command, executor, in, out);
  } catch (const operations::ExecutionError& problem) {
    throw Failure(ExitStatus::wrong_specification, command.file, problem.what(),
                  "workcell operation run FILE --step, then list, shows the icons");
  }
}

}  // namespace pal::workcell
