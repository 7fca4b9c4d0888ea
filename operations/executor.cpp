#include "operations/executor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "operations/codes.hpp"

namespace pal::operations {
namespace {

// An operation of this many MERGEs in a row, and not one skill, is a circle.
constexpr std::size_t most_idle = 100'000;

// A wait looks again after this long.
constexpr Duration between_readings = std::chrono::milliseconds(10);

Duration duration_of(double seconds) {
  return Duration(static_cast<std::int64_t>(seconds * 1e9));
}

bool is_step(IconKind kind) {
  return kind == IconKind::skill || kind == IconKind::delay || kind == IconKind::wait ||
         kind == IconKind::test;
}

}  // namespace

const char* name(ExecutionState state) {
  static constexpr std::array names{"ready", "running", "paused", "stopped", "ended", "failed"};
  return names[static_cast<std::size_t>(state)];
}

Executor::Executor(Program program, SkillRunner& runner, StepObserver* observer, const Skills* skills)
    : program_(std::move(program)), graph_(program_), runner_(runner), observer_(observer), skills_(skills) {
  enter(0);
}

ExecutionState Executor::run() {
  return run(std::numeric_limits<std::size_t>::max());
}

ExecutionState Executor::step() {
  return run(1);
}

ExecutionState Executor::run(std::size_t steps) {
  if (state_ == ExecutionState::ended || state_ == ExecutionState::failed || steps == 0) return state_;
  // After a stop before the first skill none may run; a later stop is dealt with in act().
  if (state_ == ExecutionState::stopped) {
    stop_.store(false, std::memory_order_relaxed);
    runner_.allow();
  }
  const bool resumed = state_ != ExecutionState::ready;
  state_ = ExecutionState::running;
  reason_.clear();
  const std::size_t last = steps > std::numeric_limits<std::size_t>::max() - steps_
                               ? std::numeric_limits<std::size_t>::max()
                               : steps_ + steps;
  bool leaving = resumed;  // the breakpoint at which it stands
  while (state_ == ExecutionState::running) {
    if (observer_ != nullptr) observer_->arrives(token());
    if (stop_.load(std::memory_order_relaxed)) {
      halt(ExecutionState::stopped, "stopped before " + token());
    } else if (pause_.exchange(false, std::memory_order_relaxed)) {
      halt(ExecutionState::paused, "paused before " + token());
    } else if (!std::exchange(leaving, false) && at_breakpoint()) {
      halt(ExecutionState::paused, "breakpoint at " + token());
    } else {
      const std::size_t before = steps_;
      const bool acts = is_step(icon().kind);
      if (acts && steps_ == last) {
        halt(ExecutionState::paused, "paused before " + token());
      } else {
        act();
        idle_ = steps_ == before ? idle_ + 1 : 0;
        if (idle_ > most_idle && state_ == ExecutionState::running)
          halt(ExecutionState::failed, "the token goes round in a loop in which no skill runs");
      }
    }
  }
  return state_;
}

void Executor::stop() noexcept {
  stop_.store(true, std::memory_order_relaxed);
  runner_.stop();
}

void Executor::allow() {
  if (state_ == ExecutionState::stopped) state_ = ExecutionState::paused;
  pause_.store(false, std::memory_order_relaxed);
  stop_.store(false, std::memory_order_relaxed);
  runner_.allow();
}

bool Executor::at_breakpoint() const {
  return std::any_of(breakpoints_.begin(), breakpoints_.end(), [&](const Breakpoint& each) {
    return (!each.code || *each.code == last_code_) && each.icon == token();
  });
}

std::string Executor::token() const {
  std::string path;
  for (const Frame& frame : token_) {
    if (!path.empty()) path += '/';
    path += program_.operations[frame.operation].icons[frame.icon].id;
  }
  return path;
}

std::vector<Executor::Frame> Executor::find(const std::string& path) const {
  std::vector<Frame> frames;
  std::size_t operation = 0;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const std::string id = path.substr(begin, end - begin);
    const Operation& here = program_.operations[operation];
    const auto found = graph_.find(operation, id);
    if (!found) throw ExecutionError(fmt::format("operation '{}' has no icon '{}'", here.name, id));
    frames.push_back({operation, *found});
    begin = end + 1;
    if (end == path.size()) break;
    const auto sub = graph_.sub_operation({operation, *found});
    if (!sub) throw ExecutionError(fmt::format("'{}' is no hierarchical icon", id));
    operation = *sub;
  }
  return frames;
}

void Executor::start_from(const std::string& icon) {
  if (state_ == ExecutionState::running) throw ExecutionError("a skill is running; pause first");
  token_ = find(icon);
  counts_.clear();
  last_code_ = 0;
  state_ = ExecutionState::ready;
  stop_.store(false, std::memory_order_relaxed);
  runner_.allow();
}

void Executor::set_parameter(const std::string& icon, const std::string& parameter, Value value) {
  if (state_ == ExecutionState::running) throw ExecutionError("a skill is running; pause first");
  const Frame frame = find(icon).back();
  Icon& found = program_.operations[frame.operation].icons[frame.icon];
  if (found.kind != IconKind::skill) throw ExecutionError(fmt::format("'{}' is no skill", icon));
  Icon changed = found;
  const auto given = std::find_if(changed.parameters.begin(), changed.parameters.end(),
                                  [&](const Parameter& each) { return each.name == parameter; });
  if (given != changed.parameters.end()) {
    given->value = std::move(value);
    given->count_of.clear();
  } else {
    changed.parameters.push_back({parameter, std::move(value), {}, {}});
  }
  if (skills_ != nullptr) {
    Diagnostics diagnostics;
    check_skill(changed, *skills_, std::nullopt, diagnostics);
    for (const Diagnostic& finding : diagnostics.all())
      if (finding.severity == Severity::error)
        throw ExecutionError(fmt::format("{}; {}", finding.message, finding.hint));
  }
  found.parameters = std::move(changed.parameters);
}

void Executor::add_breakpoint(Breakpoint breakpoint) {
  find(breakpoint.icon);
  breakpoints_.push_back(std::move(breakpoint));
}

/// The cell is readied once, before the first thing that happens, wherever the token starts.
bool Executor::begin() {
  if (initialised_) return true;
  if (const auto problem = runner_.initialise()) {
    halt(ExecutionState::failed, "the cell cannot be readied: " + *problem);
    return false;
  }
  initialised_ = true;
  return true;
}

void Executor::act() {
  if (!begin()) return;
  const Icon& here = icon();
  switch (here.kind) {
    case IconKind::start:
      last_code_ = 0;
      return go(here.next);
    case IconKind::merge:
      return go(here.next);
    case IconKind::branch:
      if (const auto way = way_of(here, last_code_)) return go(*way);
      return halt(ExecutionState::failed,
                  fmt::format("CASE '{}' has no way for code {}", token(), last_code_));
    case IconKind::delay:
      return act_delay();
    case IconKind::wait:
      return act_wait();
    case IconKind::test:
      return act_test();
    case IconKind::sub_operation:
      if (const auto sub = graph_.sub_operation(token_.back())) return enter(*sub);
      return halt(ExecutionState::failed, fmt::format("'{}' has no operation", token()));
    case IconKind::restart:
      token_.back().icon = start_of(token_.back().operation);
      forget_counts(token_.back().operation);
      return;
    case IconKind::exit:
      return exit_operation();
    case IconKind::skill:
      return act_skill();
  }
}

void Executor::act_skill() {
  const Icon& here = icon();
  Step step{++steps_, token(), here.skill, counted(here.parameters), {}, runner_.now(), {}};
  if (observer_ != nullptr) observer_->begins(step);
  step.result = runner_.run(here.skill, step.parameters);
  step.end = runner_.now();
  if (observer_ != nullptr) observer_->done(step);
  if (step.result.kind == SkillResult::Kind::stopped)
    return halt(ExecutionState::stopped, "stopped in " + token());
  if (step.result.kind == SkillResult::Kind::normal) count_here();
  leave_with(step.result);
}

void Executor::leave_with(const SkillResult& result) {
  last_code_ = result.code;
  const auto way = route(graph_, token_.back(), last_code_, result.kind == SkillResult::Kind::normal);
  if (way) return go(*way);
  halt(ExecutionState::failed,
       fmt::format("'{}' ended with code {}, which no icon handles: {}", token(), last_code_, result.reason));
}

/// A delay or a wait that is not over; it begins again after a resume.
void Executor::cut_off(Step& step) {
  const bool paused =
      !stop_.load(std::memory_order_relaxed) && pause_.exchange(false, std::memory_order_relaxed);
  step.result = {SkillResult::Kind::stopped, 0, paused ? "paused" : "stopped"};
  step.end = runner_.now();
  if (observer_ != nullptr) observer_->done(step);
  halt(paused ? ExecutionState::paused : ExecutionState::stopped, step.result.reason + " in " + token());
}

void Executor::act_delay() {
  Step step{++steps_, token(), {}, {}, {}, runner_.now(), {}};
  if (observer_ != nullptr) observer_->begins(step);
  if (!runner_.delay(duration_of(icon().seconds))) return cut_off(step);
  step.end = runner_.now();
  if (observer_ != nullptr) observer_->done(step);
  go(icon().next);
}

void Executor::act_test() {
  const Icon& here = icon();
  Step step{++steps_, token(), {}, {}, {}, runner_.now(), {}, here.sensor};
  if (observer_ != nullptr) observer_->begins(step);
  const Reading reading = runner_.sense(here.sensor);
  if (reading.stopped) return cut_off(step);
  step.reading = reading.value;
  if (reading.value) {
    step.result = {SkillResult::Kind::normal, code_of(here, *reading.value), {}};
  } else {
    step.result = {SkillResult::Kind::error, sensor_failed, reading.problem};
  }
  step.end = runner_.now();
  if (observer_ != nullptr) observer_->done(step);
  leave_with(step.result);
}

void Executor::act_wait() {
  const Icon& here = icon();
  Step step{++steps_, token(), {}, {}, {}, runner_.now(), {}, here.sensor};
  if (observer_ != nullptr) observer_->begins(step);
  for (bool over = false; !over;) {
    const Reading reading = runner_.sense(here.sensor);
    if (reading.stopped || pause_.load(std::memory_order_relaxed)) return cut_off(step);
    step.reading = reading.value;
    over = true;
    if (!reading.value) {
      step.result = {SkillResult::Kind::error, sensor_failed, reading.problem};
    } else if (is_met(here, *reading.value)) {
      step.result = {SkillResult::Kind::normal, 0, {}};
    } else if (here.timeout && runner_.now() - step.begin >= duration_of(*here.timeout)) {
      step.result = {SkillResult::Kind::contingency, waited_in_vain, "the time is over"};
    } else if (!runner_.delay(between_readings)) {
      return cut_off(step);
    } else {
      over = false;
    }
  }
  step.end = runner_.now();
  if (observer_ != nullptr) observer_->done(step);
  leave_with(step.result);
}

void Executor::go(const Connection& to) {
  const auto next = graph_.target(token_.back().operation, to);
  if (!next) return halt(ExecutionState::failed, fmt::format("'{}' leads to no icon '{}'", token(), to.icon));
  token_.back().icon = *next;
}

std::vector<Parameter> Executor::counted(std::vector<Parameter> parameters) const {
  for (Parameter& parameter : parameters) {
    if (parameter.count_of.empty()) continue;
    const auto found = counts_.find({token_.back().operation, parameter.count_of});
    parameter.value = found == counts_.end() ? 0.0 : static_cast<double>(found->second);
    parameter.count_of.clear();
  }
  return parameters;
}

void Executor::count_here() {
  ++counts_[{token_.back().operation, icon().id}];
}

void Executor::forget_counts(std::size_t operation) {
  std::erase_if(counts_, [&](const auto& each) { return each.first.first == operation; });
}

std::size_t Executor::start_of(std::size_t operation) const {
  if (const auto start = graph_.start(operation)) return *start;
  throw ExecutionError(fmt::format("operation '{}' has no START", program_.operations[operation].name));
}

void Executor::enter(std::size_t operation) {
  forget_counts(operation);
  token_.push_back({operation, start_of(operation)});
}

void Executor::exit_operation() {
  const std::string path = token();
  last_code_ = icon().code.value_or(last_code_);
  if (token_.size() == 1)
    return halt(ExecutionState::ended, fmt::format("exit '{}' with code {}", path, last_code_));
  token_.pop_back();
  if (last_code_ == 0) count_here();
  if (const auto way = route(graph_, token_.back(), last_code_, last_code_ == 0)) return go(*way);
  halt(ExecutionState::failed,
       fmt::format("'{}' ended with code {}, which no icon handles", token(), last_code_));
}

void Executor::halt(ExecutionState state, std::string reason) {
  state_ = state;
  reason_ = std::move(reason);
}

}  // namespace pal::operations
