#include "runtime/run.hpp"

#include <algorithm>
#include <utility>

#include "runtime/thrown.hpp"

namespace pal::runtime {

using State = ThreadControl::State;
using trace::Kind;

namespace {

constexpr std::size_t queue_capacity = 4096;
// More than this at one instant is a skill that spins without taking time.
constexpr std::uint64_t most_events_at_one_instant = 1'000'000;

}  // namespace

Run::Run(Skill& skill, World& world, const std::vector<Connection>& connections, const RunOptions& options)
    : skill_(skill),
      world_(world),
      wiring_(skill.wiring()),
      options_(options),
      recorder_(wiring_, options.trace_capacity),
      costs_(options.costs, options.seed),
      queue_(queue_capacity),
      scheduler_(*this, wiring_),
      mail_(*this, wiring_),
      blocks_(*this),
      conditions_(wiring_.conditions.size(), false) {
  for (std::size_t d = 0; d < connections.size(); ++d) {
    const Connection& connection = connections[d];
    for (std::size_t port = 0; port < connection.channels.size(); ++port) {
      if (connection.channels[port] >= 0) mail_.connect(connection.channels[port], static_cast<int>(d), port);
    }
    devices_.emplace_back(*this, static_cast<int>(d), *connection.device, connection.channels);
  }
  for (std::size_t i = 0; i < wiring_.threads.size(); ++i) {
    threads_.emplace_back(*this, static_cast<int>(i), wiring_.threads[i], wiring_.conditions.size());
    scheduler_.add(threads_.back());
  }
  resuming_.reserve(threads_.size());
}

Outcome Run::execute() {
  try {
    start_skill();
    while (!over_) step();
  } catch (...) {
    fail_at(-1, -1, "the run: " + what_was_thrown());
  }
  close_devices();
  for (const CompletionSpec& completion : skill_.description().completions) {
    if (!outcome_.fault && completion.code == outcome_.code) outcome_.reason = completion.description;
  }
  outcome_.duration = now_;
  outcome_.trace = recorder_.take();
  return std::move(outcome_);
}

void Run::start_skill() {
  for (DeviceLink& link : devices_) {
    try {
      link.device().attach(link);
    } catch (...) {
      fail_device(static_cast<int>(&link - &devices_.front()),
                  link.device().name() + ": " + what_was_thrown());
      return;
    }
  }
  try {
    skill_.start();
  } catch (const ParameterError& refused) {
    fail_at(-1, -1, refused.what());
    return;
  } catch (...) {
    fail_at(-1, -1, "starting the skill: " + what_was_thrown());
    return;
  }
  for (Thread& thread : threads_) {
    thread.control.task = skill_.body(static_cast<std::size_t>(thread.control.index), thread);
    if (!thread.control.task) {
      fail_at(-1, -1, "the skill has no body for its thread " + std::string(thread.control.spec->name));
      return;
    }
  }
  if (!threads_.empty()) skill_.reserve_executed(threads_.front());
  for (Thread& thread : threads_) {
    if (thread.control.spec->parent < 0) begin(thread);
  }
  settle();
}

// Time.

bool Run::stale(const Event& event) const {
  switch (event.kind) {
    case Event::Kind::work_done:
      return !scheduler_.expects(event.subject, event.token);
    case Event::Kind::message_available:
    case Event::Kind::request_arrives:
      return !mail_.expects_message(event.subject, event.token);
    case Event::Kind::wait_expired: {
      const ThreadControl& control = threads_[static_cast<std::size_t>(event.subject)].control;
      return control.waiting == nullptr || control.wait_token != event.token;
    }
    case Event::Kind::device_action:
      return !queue_.expects_action(event);
  }
  return false;
}

// Brings the clock and the world to `when`. False: the run is over, or something came in on the way.
bool Run::go_to(Time when) {
  if (when > options_.horizon) {
    now_ = options_.horizon;
    fail_at(-1, -1,
            "the run is longer than its limit of " + std::to_string(now_.count()) + " ns" + who_waits());
    return false;
  }
  try {
    const Time reached = world_.wait_until(when);
    if (reached > now_) events_now_ = 0;
    now_ = reached;
    world_.advance_to(reached);
  } catch (...) {
    fail_at(-1, -1, "the world: " + what_was_thrown());
  }
  return !over_ && now_ == when;
}

void Run::step() {
  if (options_.control != nullptr && options_.control->stopping()) {
    fail_at(-1, -1, "stopped on request");
    return;
  }
  while (!queue_.empty() && stale(queue_.next())) queue_.pop();
  const Time own = queue_.empty() ? Time::max() : queue_.next().time;
  const Time in_world = world_.next_event();
  if (own == Time::max() && in_world == Time::max()) {
    fail_at(-1, -1, "nothing is left to happen" + who_waits());
    return;
  }
  if (++events_now_ > most_events_at_one_instant) {
    fail_at(-1, -1, "the skill goes on and on without taking time" + who_waits());
    return;
  }
  if (in_world <= own) {  // what arrives at an instant is there before anything else happens at it
    go_to(in_world);
  } else if (own == now_ || go_to(own)) {
    happen(queue_.pop());
  }
  settle();
}

void Run::happen(const Event& event) {
  switch (event.kind) {
    case Event::Kind::work_done: {
      Thread& thread = scheduler_.finish_work(event.subject);
      try {
        thread.control.operation->work_done();
      } catch (...) {
        fail_by_exception(thread);
      }
      break;
    }
    case Event::Kind::message_available:
      mail_.message_available(event.subject);
      break;
    case Event::Kind::wait_expired:
      mail_.wait_expired(thread(event.subject));
      break;
    case Event::Kind::request_arrives:
      mail_.request_arrives(event.subject);
      break;
    case Event::Kind::device_action: {
      const auto device = static_cast<int>(event.token);
      try {
        queue_.take_action(event)();
      } catch (...) {
        fail_device(device, devices_[event.token].device().name() + ": " + what_was_thrown());
      }
      break;
    }
  }
}

// Coroutines go on one after the other; then the processors are given to those who should have them.
void Run::settle() {
  while (!over_ && !resuming_.empty()) {
    Thread& thread = *resuming_.front();
    resuming_.erase(resuming_.begin());
    thread.control.resuming = false;
    const auto others = static_cast<std::ptrdiff_t>(resuming_.size());
    if (thread.control.cancelled) {
      blocks_.stop(thread);
    } else {
      thread.control.resume_point.resume();
    }
    // Reaching a statement is one with what leads to it: the blocks of a CONCURRENT begin before others go
    // on.
    std::rotate(resuming_.begin(), resuming_.begin() + others, resuming_.end());
  }
  if (!over_) scheduler_.dispatch();
}

// Threads.

void Run::begin(Thread& thread) {
  ThreadControl& control = thread.control;
  if (control.state != State::idle) {  // the coroutine of the last time is used up
    control.task.reset();
    control.task = skill_.body(static_cast<std::size_t>(control.index), thread);
  }
  control.state = State::blocked;
  control.cancelled = false;
  control.operation = nullptr;
  for (auto& latch : control.latched) latch.reset();
  control.resume_point = control.task.handle();
  proceed(thread);
}

void Run::block(Thread& thread, int subject) {
  scheduler_.leave(thread);
  thread.control.state = State::blocked;
  thread.control.blocked_order = ++blocked_;
  record(Kind::block, thread, subject);
}

void Run::proceed(Thread& thread) {
  thread.control.resuming = true;
  resuming_.push_back(&thread);
}

// Conditions.

void Run::set_condition(Thread& thread, int condition, bool value) {
  conditions_[static_cast<std::size_t>(condition)] = value;
  record(Kind::set, thread, condition, value ? 1 : 0);
}

bool Run::read_condition(Thread& thread, int condition) {
  const bool value = conditions_[static_cast<std::size_t>(condition)];
  record(Kind::read, thread, condition, value ? 1 : 0);
  return value;
}

// Devices.

void Run::open_device(int device) {
  DeviceLink& link = devices_[static_cast<std::size_t>(device)];
  try {
    link.open();
  } catch (...) {
    fail_device(device, link.device().name() + ": " + what_was_thrown());
  }
}

void Run::observe(const Device& device, std::size_t port, std::span<const double> fields) {
  if (options_.observer != nullptr) options_.observer->passed(now_, device, port, fields);
}

void Run::hand_to_device(int device, std::size_t port, std::span<const double> fields) {
  if (over_) return;
  Device& receiver = devices_[static_cast<std::size_t>(device)].device();
  observe(receiver, port, fields);
  try {
    receiver.receive(port, fields);
  } catch (...) {
    fail_device(device, receiver.name() + ": " + what_was_thrown());
  }
}

bool Run::withdraw_from_device(int device, std::size_t port) {
  Device& receiver = devices_[static_cast<std::size_t>(device)].device();
  try {
    return receiver.withdraw(port);
  } catch (...) {
    fail_device(device, receiver.name() + ": " + what_was_thrown());
    return true;
  }
}

void Run::close_devices() {
  for (DeviceLink& link : devices_) {
    try {
      link.device().close();
    } catch (...) {
      outcome_.fault = true;
      outcome_.code = error_code();
      outcome_.reason += (outcome_.reason.empty() ? "closing " : "; closing ") + link.device().name() + ": " +
                         what_was_thrown();
    }
  }
}

// Ends.

int Run::error_code() const {
  for (const CompletionSpec& completion : skill_.description().completions) {
    if (completion.kind == CompletionSpec::Kind::error) return completion.code;
  }
  return -1;
}

void Run::complete(Thread& thread, int code) {
  if (over_) return;
  record(Kind::complete, thread, -1, code);
  record(Kind::done, thread);
  over_ = true;
  outcome_.code = code;
}

void Run::fail_at(int actor, int statement, const std::string& reason) {
  if (over_) return;
  over_ = true;
  outcome_.fault = true;
  outcome_.code = error_code();
  outcome_.reason = reason;
  recorder_.add_fault(now_, actor, statement, reason);
  recorder_.add(now_, Kind::complete, actor, statement, -1, outcome_.code);
}

void Run::fail(const Thread& thread, const std::string& reason) {
  const Operation* operation = thread.control.operation;
  fail_at(thread.control.index, operation == nullptr ? -1 : operation->statement(),
          place_of(thread) + ": " + reason);
}

void Run::fail_device(int device, const std::string& reason) {
  fail_at(actor_of_device(device), -1, reason);
}

void Run::fail_by_exception(const Thread& thread) {
  fail(thread, what_was_thrown());
}

std::string Run::place_of(const Thread& thread) const {
  const Operation* operation = thread.control.operation;
  if (operation == nullptr) return std::string(thread.control.spec->name);
  const StatementSpec& statement = wiring_.statements[static_cast<std::size_t>(operation->statement())];
  return std::string(thread.control.spec->name) + " at " + std::string(statement.text) + " (" +
         std::string(statement.file) + ":" + std::to_string(statement.line) + ")";
}

std::string Run::who_waits() const {
  std::string text;
  for (const Thread& thread : threads_) {
    const State state = thread.control.state;
    if (state != State::idle && state != State::ended)
      text += (text.empty() ? ": " : ", ") + place_of(thread);
  }
  return text;
}

// The trace. Nothing happens any more when the skill is over.

void Run::record(Kind kind, const Thread& thread, int subject, std::int32_t value) {
  if (over_) return;
  const Operation* operation = thread.control.operation;
  recorder_.add(now_, kind, thread.control.index, operation == nullptr ? -1 : operation->statement(), subject,
                value);
}

void Run::record_device(Kind kind, int device, int subject, std::int32_t value) {
  if (over_) return;
  recorder_.add(now_, kind, actor_of_device(device), -1, subject, value);
}

void Run::record_drop(int channel, std::int32_t serial) {
  if (over_) return;
  recorder_.add(now_, Kind::drop, -1, -1, channel, serial);
}

void Run::overrun(int device, int channel) {
  ++outcome_.overruns;
  record_device(Kind::overrun, device, channel);
}

}  // namespace pal::runtime
