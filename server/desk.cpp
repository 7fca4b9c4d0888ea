#include "server/desk.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <variant>

#include "pal/support/text_width.hpp"
#include "server/access.hpp"
#include "server/desk_parts.hpp"

namespace pal::server {

const char* name(Activity activity) {
  static constexpr std::array names{"idle", "skill", "operation", "service"};
  return names[static_cast<std::size_t>(activity)];
}

Desk::Parts::Parts(operations::SkillRunner& the_runner, operations::Skills the_skills, EventSink& the_sink,
                   DeskOptions the_options)
    : runner(the_runner),
      asking_runner(the_runner, *this),
      sink(the_sink),
      options(std::move(the_options)),
      epoch(make_token().substr(0, 12)),
      cell{std::move(the_skills), options.sensors, options.figures,         options.locations,
           options.unable,        options.longest, options.refused_together} {
  status.cell = options.cell;
  status.epoch = epoch;
}

void Desk::Parts::publish(decltype(Event::what) what) {
  published.push_back({++status.last_event, time_now(), std::move(what), std::chrono::system_clock::now()});
}

void Desk::Parts::hand_on(std::unique_lock<std::mutex>& lock) noexcept {
  const auto answers_now = std::exchange(answers, {});
  while (!published.empty() && !handing_on) {
    handing_on = true;
    const std::vector<Event> events = std::exchange(published, {});
    lock.unlock();
    for (const Event& event : events) sink.happened(event);
    lock.lock();
    handing_on = false;
  }
  lock.unlock();
  for (const auto& each : answers_now) each();
}

void Desk::Parts::publish_state() {
  publish(StateChanged{status.state, status.token, status.reason, status.last_code, status.steps});
}

void Desk::Parts::look_at_executor() {
  status.operation = executor->program().operations.front().name;
  status.state = executor->state();
  status.token = executor->token();
  status.reason = executor->reason();
  status.last_code = executor->last_code();
  status.steps = executor->steps();
  breakpoints = executor->breakpoints();
}

std::shared_ptr<const operations::Cell> Desk::Parts::known_cell() const {
  if (!cell_copy) cell_copy = std::make_shared<operations::Cell>(cell);
  return cell_copy;
}

const std::string& Desk::Parts::name_of(ClientId client) const {
  static const std::string nobody;
  const auto found = clients.find(client);
  return found == clients.end() ? nobody : found->second.name;
}

std::vector<Present> Desk::Parts::present() const {
  std::vector<Present> result;
  for (const auto& [id, client] : clients)
    result.push_back({id, client.name, client.role, holder == id, client.since});
  return result;
}

Desk::Desk(operations::SkillRunner& runner, operations::Skills skills, EventSink& sink, DeskOptions options)
    : parts_(std::make_unique<Parts>(runner, std::move(skills), sink, std::move(options))) {}

Desk::~Desk() = default;

ClientId Desk::enter(std::string name, Role role) {
  const Locked lock(*parts_);
  // It is shown at others' terminals, which some characters command.
  parts_->clients[++parts_->last_client] = {printable(name), role, std::chrono::system_clock::now()};
  parts_->publish(ClientsChanged{parts_->present()});
  return parts_->last_client;
}

void Desk::leave(ClientId client) {
  Parts& parts = *parts_;
  const Locked lock(parts);
  std::erase_if(parts.asking, [client](const ControlsAsked& each) { return each.client == client; });
  if (parts.stops_without == client && parts.status.activity == Activity::skill)
    parts.stop(parts.name_of(client) + ", who has gone");
  if (parts.holder == client) {
    if (parts.status.activity == Activity::operation && parts.options.pause_when_holder_goes)
      parts.pause(parts.name_of(client) + ", who has gone");
    parts.give_controls(std::nullopt);
  }
  if (parts.clients.erase(client) > 0 && !parts.ending) parts.publish(ClientsChanged{parts.present()});
}

void Desk::ask(ClientId client, Command command, Answerer answer, const operations::Stop& stop) {
  Parts::Asked asked{client, std::move(answer)};
  std::optional<Refusal> refusal;
  try {
    if (auto* load = std::get_if<LoadOperation>(&command)) {
      refusal = parts_->load(asked, std::move(*load), stop);
    } else {
      const Locked lock(*parts_);
      refusal = parts_->need_role(asked, command);
      if (!refusal) refusal = std::visit([&](auto& each) { return parts_->obey(asked, each); }, command);
    }
  } catch (const operations::ExecutionError& problem) {
    refusal = Refusal{Refusal::Why::wrong, problem.what()};
  }
  // What has taken the answerer answers later.
  if (refusal) {
    asked.answer(*refusal);
  } else if (asked.answer) {
    asked.answer(asked.done);
  }
}

Status Desk::status(ClientId client) const {
  const std::lock_guard lock(parts_->mutex);
  Status status = parts_->status;
  status.yours = parts_->holder == client;
  status.time = parts_->time_now();
  status.wall = std::chrono::system_clock::now();
  return status;
}

Snapshot Desk::snapshot(ClientId client) const {
  Snapshot result;
  result.status = status(client);
  const std::lock_guard lock(parts_->mutex);
  // What has happened since is in both.
  result.status.last_event = parts_->status.last_event;
  result.client = client;
  if (const auto found = parts_->clients.find(client); found != parts_->clients.end())
    result.role = found->second.role;
  result.loaded = parts_->loaded;
  result.changed = parts_->changes;
  result.breakpoints = parts_->breakpoints;
  result.icons = parts_->icons;
  result.here = parts_->here;
  result.clients = parts_->present();
  result.asking = parts_->asking;
  return result;
}

std::vector<Present> Desk::clients() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->present();
}

std::vector<operations::Breakpoint> Desk::breakpoints() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->breakpoints;
}

std::variant<Outlook, Refusal> Desk::outlook(const std::string& icon) const {
  const std::lock_guard lock(parts_->mutex);
  if (auto refusal = parts_->need_operation()) return *refusal;
  if (auto refusal = parts_->need_rest()) return *refusal;
  try {
    return outlook_of(*parts_->executor, *parts_->cell.skills, parts_->step_before, parts_->cut_off, icon);
  } catch (const operations::ExecutionError& problem) {
    return Refusal{Refusal::Why::wrong, problem.what(), {}, {{}, {}, icon, {}}};
  }
}

std::variant<IconValues, Refusal> Desk::values(const std::string& icon) const {
  const std::lock_guard lock(parts_->mutex);
  if (auto refusal = parts_->need_operation()) return *refusal;
  try {
    return values_of(*parts_->executor, *parts_->cell.skills, icon);
  } catch (const operations::ExecutionError& problem) {
    return Refusal{Refusal::Why::wrong, problem.what(), {}, {{}, {}, icon, {}}};
  }
}

const operations::Skills& Desk::skills() const {
  return *parts_->cell.skills;
}

const operations::Sensors& Desk::sensors() const {
  return parts_->options.sensors;
}

const Locations* Desk::locations() const {
  return parts_->options.book;
}

bool Desk::can_jog() const {
  return parts_->options.pendant != nullptr && parts_->cell.skills->contains(std::string(skill_by_hand));
}

std::map<std::string, LastReading> Desk::readings() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->readings;
}

std::shared_ptr<const operations::Cell> Desk::cell() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->known_cell();
}

const std::string& Desk::epoch() const {
  return parts_->epoch;
}

void Desk::tell(decltype(Event::what) what) {
  const Locked lock(*parts_);
  parts_->publish(std::move(what));
}

void Desk::end() {
  const Locked lock(*parts_);
  if (std::exchange(parts_->ending, true)) return;
  parts_->stop("the server");
  parts_->publish(ServerEnds{"the server ends"});
  parts_->changed.notify_all();
  parts_->answered.notify_all();
}

bool Desk::work() {
  std::optional<Parts::SkillJob> skill;
  std::optional<Parts::OperationJob> operation;
  std::optional<Parts::ServiceJob> service;
  {
    const std::lock_guard lock(parts_->mutex);
    skill = std::exchange(parts_->skill_job, std::nullopt);
    operation = std::exchange(parts_->operation_job, std::nullopt);
    service = std::exchange(parts_->service_job, std::nullopt);
  }
  if (skill) parts_->work_on(*skill);
  if (operation) parts_->work_on(*operation);
  if (service) parts_->work_on(*service);
  return skill || operation || service;
}

void Desk::wait(std::chrono::milliseconds longest) {
  std::unique_lock lock(parts_->mutex);
  parts_->changed.wait_for(lock, longest, [this] {
    return parts_->ending || parts_->skill_job || parts_->operation_job || parts_->service_job;
  });
}

bool Desk::ended() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->ending;
}

void Desk::tell_time(Duration now) noexcept {
  parts_->set_time(now);
}

}  // namespace pal::server
