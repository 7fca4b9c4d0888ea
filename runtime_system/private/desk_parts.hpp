// What a desk is made of: its state, how commands change it (desk_commands.cpp), and how the cell works on
// what was accepted (desk_work.cpp).
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime_system/desk.hpp"

namespace pal::runtime_system {

/// The answer to a command that is wrong in itself.
inline Refusal wrong(std::string message) {
  return {Refusal::Why::wrong, std::move(message)};
}

struct Desk::Parts final : operations::StepObserver {
  struct SkillJob {
    RunSkill command;
    Answerer answer;
  };
  struct OperationJob {
    std::size_t steps = 0;  // 0: until something halts it
  };

  Parts(operations::SkillRunner& the_runner, operations::Skills the_skills, EventSink& the_sink,
        DeskOptions the_options);

  // What follows is called with the lock held, except where it says who calls it.
  void publish(decltype(Event::what) what);
  void publish_state();
  void look_at_executor();
  void give_controls(std::optional<ClientId> client);
  // Controls are taken by what is obeyed, never by what is refused.
  std::optional<Refusal> need_controls(ClientId client) const {
    if (ending) return Refusal{Refusal::Why::ending, "the server ends"};
    if (holder && *holder != client)
      return Refusal{
          Refusal::Why::not_yours,
          fmt::format("'{}' has the controls; only pause and stop are for everybody", status.holder)};
    return std::nullopt;
  }
  std::optional<Refusal> need_rest() const {
    if (status.activity == Activity::idle) return std::nullopt;
    return Refusal{Refusal::Why::busy,
                   fmt::format("{} runs; pause or stop it first",
                               status.activity == Activity::skill ? "a skill" : "an operation")};
  }
  std::optional<Refusal> need_operation() const {
    if (executor) return std::nullopt;
    return Refusal{Refusal::Why::nothing, "no operation is loaded"};
  }
  void pause();

  std::optional<Refusal> obey(ClientId client, TakeControls&, Answerer&) {
    if (auto refusal = need_controls(client)) return refusal;
    give_controls(client);
    return std::nullopt;
  }
  std::optional<Refusal> obey(ClientId client, ReleaseControls&, Answerer&) {
    if (holder == client) give_controls(std::nullopt);
    return std::nullopt;
  }
  std::optional<Refusal> obey(ClientId, Pause&, Answerer&) {
    if (status.activity == Activity::skill)
      return Refusal{Refusal::Why::nothing, "a skill that runs alone cannot pause; stop ends it"};
    if (status.activity == Activity::idle) return Refusal{Refusal::Why::nothing, "nothing runs"};
    pause();
    return std::nullopt;
  }
  std::optional<Refusal> obey(ClientId, Stop&, Answerer&) {
    stop();
    return std::nullopt;
  }
  void stop();
  std::optional<Refusal> obey(ClientId client, RunSkill& command, Answerer& answer) {
    if (auto refusal = need_controls(client)) return refusal;
    if (auto refusal = need_rest()) return refusal;
    Diagnostics diagnostics;
    operations::check_skills(program_of(command), skills, options.locations, diagnostics);
    if (const auto problem = first_error(diagnostics, {})) return wrong(*problem);
    give_controls(client);
    begin(Activity::skill);
    skill_job = SkillJob{std::move(command), std::exchange(answer, nullptr)};
    return std::nullopt;
  }
  std::optional<Refusal> obey(ClientId client, LoadOperation& command, Answerer&) {
    if (auto refusal = need_controls(client)) return refusal;
    if (auto refusal = need_rest()) return refusal;
    const MemoryFileSystem files(std::move(command.files));
    SourceManager sources;
    Diagnostics diagnostics;
    auto program = operations::load(files, sources, command.main, diagnostics);
    if (program && !diagnostics.has_errors()) operations::check_shape(*program, diagnostics);
    if (program && !diagnostics.has_errors())
      operations::check_skills(*program, skills, options.locations, diagnostics);
    if (program && !diagnostics.has_errors())
      operations::check_sensors(*program, options.sensors, diagnostics);
    if (const auto problem = first_error(diagnostics, sources)) return wrong(*problem);
    if (!program) return wrong("there is no operation in it");
    give_controls(client);
    executor = std::make_unique<operations::Executor>(std::move(*program), runner, this, &skills);
    look_at_executor();
    publish(OperationLoaded{status.operation});
    return std::nullopt;
  }
  std::optional<Refusal> obey(ClientId client, RunOperation& command, Answerer&) {
    if (auto refusal = need_controls(client)) return refusal;
    if (auto refusal = need_rest()) return refusal;
    if (auto refusal = need_operation()) return refusal;
    const ExecutionState state = executor->state();
    if (command.how == RunOperation::How::resume && state != ExecutionState::paused &&
        state != ExecutionState::stopped)
      return Refusal{Refusal::Why::nothing,
                     fmt::format("the operation is {}, neither paused nor stopped; 'run' begins it",
                                 operations::name(state))};
    if (state == ExecutionState::ended || state == ExecutionState::failed) start_again();
    give_controls(client);
    begin(Activity::operation);
    operation_job = OperationJob{command.how == RunOperation::How::step ? std::size_t{1} : 0};
    status.state = ExecutionState::running;
    status.reason.clear();
    publish_state();
    return std::nullopt;
  }
  void start_again();
  std::optional<Refusal> obey(ClientId client, PutToken& command, Answerer&) {
    if (auto refusal = need_controls(client)) return refusal;
    if (auto refusal = need_rest()) return refusal;
    if (auto refusal = need_operation()) return refusal;
    executor->start_from(command.icon);
    give_controls(client);
    look_at_executor();
    publish_state();
    return std::nullopt;
  }
  std::optional<Refusal> obey(ClientId client, SetParameter& command, Answerer&) {
    if (auto refusal = need_controls(client)) return refusal;
    if (auto refusal = need_rest()) return refusal;
    if (auto refusal = need_operation()) return refusal;
    executor->set_parameter(command.icon, command.parameter, std::move(command.value));
    give_controls(client);
    return std::nullopt;
  }
  // Breakpoints of what runs are changed when the token next comes to an icon.
  std::optional<Refusal> change_breakpoints(ClientId client, std::function<void()> change, Answerer& answer) {
    if (auto refusal = need_controls(client)) return refusal;
    if (auto refusal = need_operation()) return refusal;
    if (status.activity != Activity::operation) {
      change();
    } else {
      between.emplace_back(std::move(change), std::exchange(answer, nullptr));
    }
    give_controls(client);
    return std::nullopt;
  }
  std::optional<Refusal> obey(ClientId client, SetBreakpoint& command, Answerer& answer) {
    return change_breakpoints(
        client, [this, breakpoint = command.breakpoint] { executor->add_breakpoint(breakpoint); }, answer);
  }
  std::optional<Refusal> obey(ClientId client, ClearBreakpoints&, Answerer& answer) {
    return change_breakpoints(
        client, [this] { executor->clear_breakpoints(); }, answer);
  }

  void begin(Activity activity);
  void change_between();

  // While an operation runs, by the cell's thread, without the lock.
  void arrives(const std::string& icon) override;
  void begins(const operations::Step& step) override;
  void done(const operations::Step& step) override;

  // Likewise: to the end of what was accepted.
  void work_on(const OperationJob& job);
  void work_on(const SkillJob& job);

  operations::SkillRunner& runner;
  const operations::Skills skills;
  EventSink& sink;
  const DeskOptions options;

  mutable std::mutex mutex;
  std::condition_variable changed;
  Status status;
  std::map<ClientId, std::string> clients;
  ClientId last_client = 0;
  std::optional<ClientId> holder;
  bool ending = false;
  std::size_t stops = 0, pauses = 0;                    // asked for so far
  std::size_t accepted_stops = 0, accepted_pauses = 0;  // … when the work was accepted
  std::vector<std::pair<std::function<void()>, Answerer>> between;
  std::optional<SkillJob> skill_job;
  std::optional<OperationJob> operation_job;
  // Touched by clients while the cell is idle, by the cell's thread else; but for its pause() and stop().
  std::unique_ptr<operations::Executor> executor;
  std::size_t alone = 0;  // skills that ran alone
};

}  // namespace pal::runtime_system
