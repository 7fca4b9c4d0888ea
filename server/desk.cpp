#include "server/desk.hpp"

#include <fmt/format.h>

#include <array>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <variant>

#include "server/program_check.hpp"

namespace pal::server {

using operations::ExecutionState;
using operations::Executor;

const char* name(Activity activity) {
  static constexpr std::array names{"idle", "skill", "operation"};
  return names[static_cast<std::size_t>(activity)];
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
        DeskOptions the_options)
      : runner(the_runner), skills(std::move(the_skills)), sink(the_sink), options(std::move(the_options)) {
    status.cell = options.cell;
  }

  ProgramRules rules() const { return {skills, options.sensors, options.locations}; }

  // With the lock held.
  void publish(decltype(Event::what) what) {
    sink.happened({++status.last_event, status.time, std::move(what)});
  }
  void publish_state() {
    publish(StateChanged{status.state, status.token, status.reason, status.last_code, status.steps, false});
  }
  void look_at_executor() {
    status.operation = executor->program().operations.front().name;
    status.state = executor->state();
    status.token = executor->token();
    status.reason = executor->reason();
    status.last_code = executor->last_code();
    status.steps = executor->steps();
  }
  void give_controls(std::optional<ClientId> client) {
    if (holder == client) return;
    holder = client;
    status.holder = client ? clients.at(*client) : "";
    publish(ControlsChanged{status.holder});
  }
  // Controls are taken by what is obeyed, never by what is refused.
  std::optional<Refusal> need_controls(ClientId client) const {
    if (ending) return Refusal{Refusal::Why::ending, "the server ends"};
    if (holder && *holder != client)
      return Refusal{
          Refusal::Why::not_yours,
          fmt::format("'{}' has the controls; other clients may only pause and stop", status.holder)};
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
  void pause() {
    ++pauses;
    executor->pause();
  }

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
  void stop() {
    if (status.activity == Activity::idle) return;
    ++stops;
    if (status.activity == Activity::operation) {
      executor->stop();
    } else {
      runner.stop();
    }
  }
  std::optional<Refusal> obey(ClientId client, RunSkill& command, Answerer& answer) {
    if (auto refusal = need_controls(client)) return refusal;
    if (auto refusal = need_rest()) return refusal;
    if (const auto problem = mistake_in(command, rules())) return Refusal{Refusal::Why::wrong, *problem};
    give_controls(client);
    begin(Activity::skill);
    skill_job = SkillJob{std::move(command), std::exchange(answer, nullptr)};
    return std::nullopt;
  }
  std::optional<Refusal> obey(ClientId client, LoadOperation& command, Answerer&) {
    if (auto refusal = need_controls(client)) return refusal;
    if (auto refusal = need_rest()) return refusal;
    std::variant<operations::Program, std::string> loaded = load(std::move(command), rules());
    if (const auto* mistake = std::get_if<std::string>(&loaded))
      return Refusal{Refusal::Why::wrong, *mistake};
    give_controls(client);
    executor =
        std::make_unique<Executor>(std::move(std::get<operations::Program>(loaded)), runner, this, &skills);
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
  void start_again() {
    for (const operations::Icon& icon : executor->program().operations.front().icons)
      if (icon.kind == operations::IconKind::start) return executor->start_from(icon.id);
  }
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

  void begin(Activity activity) {
    status.activity = activity;
    accepted_stops = stops;
    accepted_pauses = pauses;
    changed.notify_all();
  }
  void change_between() {
    for (auto& [change, answer] : std::exchange(between, {})) {
      Reply reply = Done{};
      try {
        change();
      } catch (const operations::ExecutionError& problem) {
        reply = Refusal{Refusal::Why::wrong, problem.what()};
      }
      answer(reply);
    }
  }

  // While an operation runs, by the cell's thread.
  void arrives(const std::string& icon) override {
    sink.make_room();
    const std::lock_guard lock(mutex);
    change_between();
    status.token = icon;
    status.time = runner.now();
    publish(IconReached{icon});
  }
  void begins(const operations::Step& step) override {
    const std::lock_guard lock(mutex);
    status.time = step.begin;
    status.steps = step.number;
    publish(StepBegins{step});
  }
  void done(const operations::Step& step) override {
    if (options.log != nullptr) options.log->done(step);
    const std::lock_guard lock(mutex);
    status.time = step.end;
    if (step.has_code()) status.last_code = step.result.code;
    publish(StepEnds{step});
  }

  void work_on(const OperationJob& job) {
    executor->allow();
    // What was asked for after the command had been accepted holds; allow() may just have forgotten it.
    {
      const std::lock_guard lock(mutex);
      if (stops != accepted_stops) executor->stop();
      if (pauses != accepted_pauses) executor->pause();
    }
    if (job.steps > 0) {
      executor->run(job.steps);
    } else {
      executor->run();
    }
    const std::lock_guard lock(mutex);
    change_between();
    status.activity = Activity::idle;
    status.time = runner.now();
    look_at_executor();
    publish_state();
  }
  void work_on(const SkillJob& job) {
    runner.allow();
    operations::Step step{++alone, {}, job.command.skill, job.command.parameters, {}, runner.now(), {}};
    {
      const std::lock_guard lock(mutex);
      if (stops != accepted_stops) runner.stop();
      status.time = step.begin;
      publish(StepBegins{step});
    }
    step.result = runner.run(job.command.skill, job.command.parameters);
    step.end = runner.now();
    if (options.log != nullptr) options.log->done(step);
    {
      const std::lock_guard lock(mutex);
      status.activity = Activity::idle;
      status.time = step.end;
      publish(StepEnds{step});
    }
    job.answer(Done{step.result, step.begin, step.end});
  }

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
  std::unique_ptr<Executor> executor;
  std::size_t alone = 0;  // skills that ran alone
};

Desk::Desk(operations::SkillRunner& runner, operations::Skills skills, EventSink& sink, DeskOptions options)
    : parts_(std::make_unique<Parts>(runner, std::move(skills), sink, std::move(options))) {}

Desk::~Desk() = default;

ClientId Desk::enter(std::string name) {
  // It is shown at others' terminals, which some characters command.
  for (char& each : name)
    if (static_cast<unsigned char>(each) < ' ' || each == '\x7f') each = '?';
  const std::lock_guard lock(parts_->mutex);
  parts_->clients[++parts_->last_client] = std::move(name);
  return parts_->last_client;
}

void Desk::leave(ClientId client) {
  const std::lock_guard lock(parts_->mutex);
  if (parts_->holder == client) {
    if (parts_->status.activity == Activity::operation && parts_->options.pause_when_holder_goes)
      parts_->pause();
    parts_->give_controls(std::nullopt);
  }
  parts_->clients.erase(client);
}

void Desk::ask(ClientId client, Command command, Answerer answer) {
  std::optional<Refusal> refusal;
  {
    const std::lock_guard lock(parts_->mutex);
    try {
      refusal = std::visit([&](auto& each) { return parts_->obey(client, each, answer); }, command);
    } catch (const operations::ExecutionError& problem) {
      refusal = Refusal{Refusal::Why::wrong, problem.what()};
    }
  }
  // What has taken the answerer answers later.
  if (refusal) {
    answer(*refusal);
  } else if (answer) {
    answer(Done{});
  }
}

Status Desk::status(ClientId client) const {
  const std::lock_guard lock(parts_->mutex);
  Status status = parts_->status;
  status.yours = parts_->holder == client;
  return status;
}

const operations::Skills& Desk::skills() const {
  return parts_->skills;
}

const operations::Sensors& Desk::sensors() const {
  return parts_->options.sensors;
}

void Desk::end() {
  const std::lock_guard lock(parts_->mutex);
  parts_->ending = true;
  parts_->stop();
  parts_->changed.notify_all();
}

bool Desk::work() {
  std::optional<Parts::SkillJob> skill;
  std::optional<Parts::OperationJob> operation;
  {
    const std::lock_guard lock(parts_->mutex);
    skill = std::exchange(parts_->skill_job, std::nullopt);
    operation = std::exchange(parts_->operation_job, std::nullopt);
  }
  if (skill) parts_->work_on(*skill);
  if (operation) parts_->work_on(*operation);
  return skill || operation;
}

void Desk::wait(std::chrono::milliseconds longest) {
  std::unique_lock lock(parts_->mutex);
  parts_->changed.wait_for(lock, longest,
                           [this] { return parts_->ending || parts_->skill_job || parts_->operation_job; });
}

bool Desk::ended() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->ending;
}

}  // namespace pal::server
