#include "operations/executor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "operations/codes.hpp"
#include "operations/missing_value.hpp"

namespace pal::operations {
namespace {

// An operation of this many MERGEs in a row, and not one skill, is a circle.
constexpr std::size_t most_idle = 100'000;

bool is_step(IconKind kind) {
  return kind == IconKind::delay || (has_completions(kind) && kind != IconKind::sub_operation);
}

}  // namespace

const char* name(ExecutionState state) {
  static constexpr std::array names{"ready", "running", "paused", "stopped", "ended", "failed"};
  return names[static_cast<std::size_t>(state)];
}

Executor::Executor(Program program, SkillRunner& runner, StepObserver* observer, const Cell* cell)
    : program_(std::move(program)), graph_(program_), runner_(runner), observer_(observer), cell_(cell) {
  enter(0, {});
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
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  run_on(steps > all - steps_ ? all : steps_ + steps, resumed);
  if (state_ == ExecutionState::stopped && initialised_) run_on_stop();
  return state_;
}

void Executor::run_on(std::size_t last, bool resumed) {
  state_ = ExecutionState::running;
  reason_.clear();
  bool leaving = resumed;  // the breakpoint at which it stands
  while (state_ == ExecutionState::running) {
    if (observer_ != nullptr) observer_->arrives(token());
    if (stop_.load(std::memory_order_relaxed)) {
      halt(ExecutionState::stopped, "stopped before " + token());
    } else if (pausing()) {
      pause_.store(false, std::memory_order_relaxed);
      halt(ExecutionState::paused, "paused before " + token());
    } else if (!std::exchange(leaving, false) && !stopping_ && at_breakpoint()) {
      halt(ExecutionState::paused, "breakpoint at " + token());
    } else if (is_step(icon().kind) && steps_ == last) {
      halt(ExecutionState::paused, "paused before " + token());
    } else {
      const std::size_t before = steps_;
      act();
      idle_ = steps_ == before ? idle_ + 1 : 0;
      if (idle_ > most_idle && state_ == ExecutionState::running)
        halt(ExecutionState::failed, "the token goes round in a loop in which no skill runs");
    }
  }
}

/// The innermost one. The token comes back to where it was; what was cut off there begins again, if it does.
void Executor::run_on_stop() {
  std::size_t depth = token_.size();
  std::optional<std::size_t> retreat;
  while (depth > 0 && !retreat) retreat = graph_.on_stop(token_[--depth].operation);
  if (!retreat) return;
  const std::vector<Frame> token = token_;
  const std::string reason = reason_;
  const int code = last_code_;
  // A second stop comes after this, and holds.
  stop_.store(false, std::memory_order_relaxed);
  runner_.allow();
  stopping_ = true;
  token_.resize(depth);
  enter(*retreat, {}, true);
  base_ = token_.size();
  run_on(std::numeric_limits<std::size_t>::max(), false);
  const std::string& name = program_.operations[*retreat].name;
  const std::string what =
      state_ == ExecutionState::ended
          ? fmt::format("then '{}' ended with code {}", name, last_code_)
          : fmt::format("then '{}' {}: {}", name,
                        state_ == ExecutionState::stopped ? "was stopped" : "failed", reason_);
  stopping_ = false;
  base_ = 1;
  token_ = token;
  last_code_ = code;
  pause_.store(false, std::memory_order_relaxed);
  halt(ExecutionState::stopped, fmt::format("{}; {}", reason, what));
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

void Executor::end_pause() {
  pause_.store(false, std::memory_order_relaxed);
  if (state_ == ExecutionState::paused) halt(ExecutionState::stopped, "stopped before " + token());
}

/// Counts the arrival at all that fit.
bool Executor::at_breakpoint() {
  bool halts = false;
  for (Breakpoint& each : breakpoints_) {
    if (!each.enabled || (each.code && *each.code != last_code_) || each.icon != token() ||
        (each.condition && !meets(*each.condition)))
      continue;
    halts = ++each.hits % std::max<std::size_t>(each.every, 1) == 0 || halts;
  }
  return halts;
}

bool Executor::meets(const BreakCondition& condition) const {
  try {
    const Value value = value_of(token_.back(), condition.source);
    const auto* truth = std::get_if<bool>(&value);
    const auto* number = std::get_if<double>(&value);
    if (truth == nullptr && number == nullptr) return false;
    const double known_value = truth != nullptr ? (*truth ? 1.0 : 0.0) : *number;
    return (!condition.at_least || known_value >= *condition.at_least) &&
           (!condition.at_most || known_value <= *condition.at_most);
  } catch (const MissingValue&) {
    return false;
  }
}

std::string Executor::token() const {
  std::string path;
  for (const Frame& frame : token_) {
    if (!path.empty()) path += '/';
    if (frame.on_stop) path += std::string(on_stop_in_path) + '/';
    path += graph_.icon(frame.place()).id;
  }
  return path;
}

std::vector<Place> Executor::find(const std::string& path) const {
  std::vector<Place> frames;
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
  const std::vector<Place> places = find(icon);
  counts_.clear();
  figures_.clear();
  memories_.clear();
  std::vector<Frame> token;
  for (const Place& place : places) {
    std::map<std::string, Value> arguments;
    try {
      // Nothing has been counted or reported yet.
      arguments = token.empty() ? arguments_of({}, 0) : arguments_of(token.back(), place.operation);
    } catch (const MissingValue& problem) {
      throw ExecutionError(fmt::format("'{}' cannot begin here: {}", icon, problem.what()));
    }
    token.push_back({place.operation, place.icon, std::move(arguments)});
  }
  token_ = std::move(token);
  last_code_ = 0;
  state_ = ExecutionState::ready;
  stop_.store(false, std::memory_order_relaxed);
  runner_.allow();
}

std::optional<Parameter> Executor::parameter(const std::string& icon, const std::string& parameter) const {
  for (const Parameter& each : graph_.icon(find(icon).back()).parameters)
    if (each.name == parameter) return each;
  return std::nullopt;
}

void Executor::set_parameter(const std::string& icon, const std::string& parameter, Value value) {
  if (state_ == ExecutionState::running) throw ExecutionError("a skill is running; pause first");
  const Place place = find(icon).back();
  Icon changed = graph_.icon(place);
  if (changed.kind != IconKind::skill && changed.kind != IconKind::sub_operation)
    throw ExecutionError(fmt::format("'{}' is no skill", icon));
  const auto given = std::find_if(changed.parameters.begin(), changed.parameters.end(),
                                  [&](const Parameter& each) { return each.name == parameter; });
  if (given != changed.parameters.end()) {
    given->value = std::move(value);
    given->source = {};
  } else {
    changed.parameters.push_back({parameter, std::move(value), {}, {}});
  }
  if (cell_ != nullptr) {
    Diagnostics diagnostics;
    check_parameters(graph_, place, changed, *cell_, diagnostics);
    for (const Diagnostic& finding : diagnostics.all())
      if (finding.severity == Severity::error)
        throw ExecutionError(fmt::format("{}; {}", finding.message, finding.hint));
  }
  program_.operations[place.operation].icons[place.icon].parameters = std::move(changed.parameters);
}

Breakpoint Executor::add_breakpoint(Breakpoint breakpoint) {
  const Place at = find(breakpoint.icon).back();
  if (breakpoint.condition) {
    const Source& source = breakpoint.condition->source;
    const Operation& here = program_.operations[at.operation];
    const bool argument = std::any_of(here.arguments.begin(), here.arguments.end(),
                                      [&](const pan::Parameter& each) { return each.name == source.name; });
    if (source.kind == Source::Kind::argument && !argument)
      throw ExecutionError(fmt::format("operation '{}' has no argument '{}'", here.name, source.name));
    if (source.kind != Source::Kind::argument && !graph_.find(at.operation, source.icon))
      throw ExecutionError(fmt::format("operation '{}' has no icon '{}'", here.name, source.icon));
  }
  for (Breakpoint& each : breakpoints_) {
    if (breakpoint.number == 0 || each.number != breakpoint.number) continue;
    breakpoint.hits = each.hits;
    return each = std::move(breakpoint);
  }
  breakpoint.number = ++last_breakpoint_;
  breakpoints_.push_back(std::move(breakpoint));
  return breakpoints_.back();
}

bool Executor::remove_breakpoint(std::size_t number) {
  return std::erase_if(breakpoints_, [number](const Breakpoint& each) { return each.number == number; }) > 0;
}

bool Executor::add_kept_breakpoints(std::size_t most) {
  // Only operations in which there are some, at whatever depth: others can be nested by the thousand.
  std::vector<bool> has_some(program_.operations.size(), false);
  for (const std::size_t o : inner_first(graph_))
    for (std::size_t i = 0; i < program_.operations[o].icons.size(); ++i) {
      const auto sub = graph_.sub_operation({o, i});
      if (program_.operations[o].icons[i].breakpoint || (sub && has_some[*sub])) has_some[o] = true;
    }
  struct Part {
    std::size_t operation = 0;
    std::string prefix;
  };
  std::vector<Part> parts{{0, ""}};
  for (std::size_t next = 0; next < parts.size(); ++next) {
    const Part part = parts[next];
    if (!has_some[part.operation]) continue;
    const auto& icons = program_.operations[part.operation].icons;
    for (std::size_t i = 0; i < icons.size(); ++i) {
      if (const auto& kept = icons[i].breakpoint) {
        if (most-- == 0) return false;
        add_breakpoint({part.prefix + icons[i].id, kept->code, kept->condition, kept->every, kept->enabled});
      }
      const auto sub = graph_.sub_operation({part.operation, i});
      if (sub && has_some[*sub]) parts.push_back({*sub, part.prefix + icons[i].id + "/"});
    }
  }
  return true;
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

void Executor::go(const Connection& to) {
  Frame& here = token_.back();
  const auto next = graph_.target(here.operation, to);
  if (!next) return halt(ExecutionState::failed, fmt::format("'{}' leads to no icon '{}'", token(), to.icon));
  here.icon = *next;
  here.times.reset();
  here.rounds = 0;
  here.attempts = 0;
}

void Executor::forget(std::size_t operation) {
  const auto is_here = [operation](const auto& each) { return each.first.first == operation; };
  std::erase_if(counts_, is_here);
  std::erase_if(figures_, is_here);
  std::erase_if(memories_, is_here);
}

std::size_t Executor::start_of(std::size_t operation) const {
  if (const auto start = graph_.start(operation)) return *start;
  throw ExecutionError(fmt::format("operation '{}' has no START", program_.operations[operation].name));
}

/// Arguments that are not given have their defaults.
void Executor::enter(std::size_t operation, std::map<std::string, Value> arguments, bool on_stop) {
  forget(operation);
  Frame frame{operation, start_of(operation), std::move(arguments), on_stop};
  for (const pan::Parameter& each : program_.operations[operation].arguments)
    frame.arguments.try_emplace(each.name, default_of(each));
  token_.push_back(std::move(frame));
}

void Executor::halt(ExecutionState state, std::string reason) {
  state_ = state;
  reason_ = std::move(reason);
}

}  // namespace pal::operations
