#include "runtime_system/desk.hpp"

#include <array>
#include <utility>

#include "runtime_system/private/desk_parts.hpp"

namespace pal::runtime_system {

const char* name(Activity activity) {
  static constexpr std::array names{"idle", "skill", "operation"};
  return names[static_cast<std::size_t>(activity)];
}

Desk::Parts::Parts(operations::SkillRunner& the_runner, operations::Skills the_skills, EventSink& the_sink,
                   DeskOptions the_options)
    : runner(the_runner), skills(std::move(the_skills)), sink(the_sink), options(std::move(the_options)) {
  status.cell = options.cell;
}

void Desk::Parts::publish(decltype(Event::what) what) {
  sink.happened({++status.last_event, status.time, std::move(what)});
}

void Desk::Parts::publish_state() {
  publish(StateChanged{status.state, status.token, status.reason, status.last_code, status.steps, false});
}

void Desk::Parts::look_at_executor() {
  status.operation = executor->program().operations.front().name;
  status.state = executor->state();
  status.token = executor->token();
  status.reason = executor->reason();
  status.last_code = executor->last_code();
  status.steps = executor->steps();
}

void Desk::Parts::give_controls(std::optional<ClientId> client) {
  if (holder == client) return;
  holder = client;
  status.holder = client ? clients.at(*client) : "";
  publish(ControlsChanged{status.holder});
}

void Desk::Parts::pause() {
  ++pauses;
  executor->pause();
}

void Desk::Parts::stop() {
  if (status.activity == Activity::idle) return;
  ++stops;
  if (status.activity == Activity::operation) {
    executor->stop();
  } else {
    runner.stop();
  }
}

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
      refusal = wrong(problem.what());
    }
  }
  // Whoever has taken the answerer answers later.
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

}  // namespace pal::runtime_system
