// What each kind of icon does when the token is there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "operations/check_values.hpp"
#include "operations/codes.hpp"
#include "operations/executor.hpp"
#include "operations/fields.hpp"
#include "operations/missing_value.hpp"

namespace pal::operations {
namespace {

// A wait and a question look again after this long.
constexpr Duration between_readings = std::chrono::milliseconds(10);

Duration duration_of(double seconds) {
  return Duration(static_cast<std::int64_t>(seconds * 1e9));
}

using ResultKind = SkillResult::Kind;

}  // namespace

Value default_of(const pan::Parameter& argument) {
  if (argument.type == pan::ScalarType::text) return argument.default_text;
  if (argument.type == pan::ScalarType::boolean) return argument.default_value != 0;
  return argument.default_value;
}

void Executor::act() {
  if (!begin()) return;
  try {
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
      case IconKind::question:
        return act_question();
      case IconKind::planned:
        return act_question();
      case IconKind::zero:
        return act_zero();
      case IconKind::sub_operation:
        return act_sub_operation();
      case IconKind::restart:
        token_.back().icon = start_of(token_.back().operation);
        return forget(token_.back().operation);
      case IconKind::exit:
        return exit_operation();
      case IconKind::skill:
        return act_skill();
    }
  } catch (const MissingValue& problem) {
    leave_without_value(problem.what());
  }
}

// Steps.

Step Executor::new_step() const {
  const Icon& here = icon();
  Step step{steps_ + 1, token(), here.kind == IconKind::planned ? "" : here.skill, {}, {}, runner_.now(), {}};
  step.sensor = subjects_text(here);
  step.question = question_text(here);
  return step;
}

void Executor::announce(const Step& step) {
  ++steps_;
  if (observer_ != nullptr) observer_->begins(step);
}

void Executor::finish(Step& step) {
  step.end = runner_.now();
  if (observer_ != nullptr) observer_->done(step);
}

/// A delay, a wait or a question that is not over; it begins again after a resume.
void Executor::cut_off(Step& step) {
  const bool paused = !stop_.load(std::memory_order_relaxed) && !stopping_ &&
                      pause_.exchange(false, std::memory_order_relaxed);
  step.result = {ResultKind::stopped, 0, paused ? "paused" : "stopped"};
  finish(step);
  halt(paused ? ExecutionState::paused : ExecutionState::stopped, step.result.reason + " in " + token());
}

// Values.

Value Executor::value_of(const Frame& frame, const Source& source) const {
  const IconName named{frame.operation, source.icon};
  switch (source.kind) {
    case Source::Kind::count: {
      const auto found = counts_.find(named);
      return found == counts_.end() ? 0.0 : static_cast<double>(found->second);
    }
    case Source::Kind::argument: {
      const auto found = frame.arguments.find(source.name);
      if (found != frame.arguments.end()) return found->second;
      throw MissingValue(fmt::format("there is no argument '{}'", source.name));
    }
    case Source::Kind::output: {
      const auto found = figures_.find(named);
      if (found == figures_.end())
        throw MissingValue(
            fmt::format("'{}' has not run yet, so it has reported no '{}'", source.icon, source.name));
      for (const Figure& figure : found->second)
        if (figure.name == source.name) return figure.value;
      throw MissingValue(fmt::format("'{}' has reported no '{}'", source.icon, source.name));
    }
    case Source::Kind::written:
      break;
  }
  return 0.0;
}

double Executor::number_of(const Amount& amount, double low, double high, const char* what) const {
  if (amount.source.written()) return amount.number;
  const Value value = value_of(token_.back(), amount.source);
  const auto* number = std::get_if<double>(&value);
  if (number != nullptr && *number >= low && *number <= high) return *number;
  throw MissingValue(
      fmt::format("{} is {}, and must be from {} to {}", to_text(amount.source), to_text(value), low, high) +
      (*what == '\0' ? "" : fmt::format(" as {}", what)));
}

std::vector<Parameter> Executor::known(const std::vector<Parameter>& parameters) const {
  std::vector<Parameter> result = parameters;
  for (Parameter& parameter : result) {
    if (parameter.source.written()) continue;
    parameter.value = value_of(token_.back(), parameter.source);
    parameter.source = {};
  }
  return result;
}

/// Of the operation that the icon of `outer` stands for. Those that are not given have their defaults.
std::map<std::string, Value> Executor::arguments_of(const Frame& outer, std::size_t operation) const {
  std::map<std::string, Value> result;
  const auto& wanted = program_.operations[operation].arguments;
  for (const pan::Parameter& each : wanted) result.emplace(each.name, default_of(each));
  if (operation == 0) return result;
  for (const Parameter& given : graph_.icon(outer.place()).parameters) {
    const auto argument = std::find_if(wanted.begin(), wanted.end(),
                                       [&](const pan::Parameter& each) { return each.name == given.name; });
    if (argument == wanted.end()) continue;
    Value value = given.source.written() ? given.value : value_of(outer, given.source);
    const auto* number = std::get_if<double>(&value);
    if (number != nullptr && !(*number >= argument->low && *number <= argument->high))
      throw MissingValue(
          fmt::format("the argument '{}' is {}, and must be {}", given.name, *number, type_text(*argument)));
    result[given.name] = std::move(value);
  }
  return result;
}

/// The icon cannot do what it should.
void Executor::leave_without_value(const std::string& problem) {
  if (!has_completions(icon().kind))
    return halt(ExecutionState::failed, fmt::format("at {}: {}", token(), problem));
  if (icon().kind != IconKind::sub_operation) {
    Step step = new_step();
    announce(step);
    step.result = {ResultKind::error, no_value, problem};
    finish(step);
  }
  leave_with(no_value, false, problem);
}

// Leaving.

void Executor::leave_with(int code, bool normal, const std::string& reason) {
  last_code_ = code;
  if (const auto way = route(graph_, token_.back().place(), code, normal)) return go(*way);
  halt(ExecutionState::failed, fmt::format("'{}' ended with code {}, which no icon handles{}{}", token(),
                                           code, reason.empty() ? "" : ": ", reason));
}

/// Whether the icon has to run at all; if not, the token has left it with code 0.
bool Executor::is_to_run() {
  Frame& here = token_.back();
  if (here.times) return true;
  constexpr double most = 1e6;
  here.times = 1;
  if (icon().repeat) here.times = static_cast<std::size_t>(number_of(*icon().repeat, 0, most, "'repeat'"));
  if (*here.times > 0) return true;
  leave_with(0, true, {});
  return false;
}

/// Counts it. The answer says whether the icon has to run again.
bool Executor::ended_normally_in_this_round() {
  ++counts_[icon_name()];
  Frame& here = token_.back();
  here.attempts = 0;
  return ++here.rounds < here.times.value_or(1);
}

void Executor::act_skill() {
  if (!is_to_run()) return;
  const Icon& here = icon();
  Step step = new_step();
  step.parameters = known(here.parameters);
  std::optional<Duration> limit;
  if (here.time_limit) limit = duration_of(number_of(*here.time_limit, 0.001, longest_time, "'time-limit'"));
  announce(step);
  step.result = runner_.run(here.skill, step.parameters, limit);
  if (step.result.over_time)
    step.result = {ResultKind::contingency, time_over,
                   fmt::format("the time limit of {} is over", to_text(*here.time_limit))};
  finish(step);
  if (step.result.kind == ResultKind::stopped) return halt(ExecutionState::stopped, "stopped in " + token());
  figures_[icon_name()] = step.result.figures;
  const bool normal = step.result.kind == ResultKind::normal;
  if (normal && ended_normally_in_this_round()) {
    last_code_ = step.result.code;
    return;
  }
  const auto& codes = here.retry_on;
  const bool may_again =
      codes.empty() || std::find(codes.begin(), codes.end(), step.result.code) != codes.end();
  if (!normal && may_again && token_.back().attempts < here.retries) {
    ++token_.back().attempts;
    last_code_ = step.result.code;
    return;
  }
  leave_with(step.result.code, normal, step.result.reason);
}

void Executor::act_sub_operation() {
  if (!is_to_run()) return;
  const auto sub = graph_.sub_operation(token_.back().place());
  if (!sub) return halt(ExecutionState::failed, fmt::format("'{}' has no operation", token()));
  enter(*sub, arguments_of(token_.back(), *sub));
}

void Executor::exit_operation() {
  const std::string path = token();
  constexpr double most = 1e6;
  if (icon().code) last_code_ = static_cast<int>(number_of(*icon().code, -most, most, "a completion code"));
  if (token_.size() == base_)
    return halt(ExecutionState::ended, fmt::format("exit '{}' with code {}", path, last_code_));
  token_.pop_back();
  if (last_code_ == 0 && ended_normally_in_this_round()) return;
  leave_with(last_code_, last_code_ == 0, {});
}

void Executor::act_delay() {
  const double seconds = number_of(*icon().seconds, 0, longest_time, "a time");
  Step step = new_step();
  announce(step);
  if (!runner_.delay(duration_of(seconds))) return cut_off(step);
  finish(step);
  go(icon().next);
}

void Executor::act_zero() {
  Step step = new_step();
  announce(step);
  const auto problem = runner_.zero(icon().sensor);
  if (problem && stop_.load(std::memory_order_relaxed)) return cut_off(step);
  if (problem) step.result = {ResultKind::error, no_value, *problem};
  finish(step);
  leave_with(step.result.code, !problem, step.result.reason);
}

// Readings.

/// The mean of as many readings as the condition asks for.
Executor::Looked Executor::sense(const Condition& condition, double& value) {
  if (condition.sensor.empty()) {
    const Value known_value = value_of(token_.back(), condition.value.source);
    value = std::get<double>(known_value);
    return {};
  }
  double sum = 0;
  for (int i = 0; i < condition.mean_of; ++i) {
    const Reading reading = runner_.sense(condition.sensor);
    if (reading.stopped) return {true, 0, {}};
    if (!reading.value) return {false, 0, reading.problem};
    sum += *reading.value;
  }
  value = sum / condition.mean_of;
  return {};
}

/// Reads everything, in the order of the file, and compares it. The code: how many limits were reached, or 1
/// if the conditions are met, else 0.
Executor::Looked Executor::look(const Icon& here, Step& step, Memory& memory) {
  constexpr double most = std::numeric_limits<double>::infinity();
  const auto bound = [this](const Amount& amount) { return number_of(amount, -most, most, ""); };
  memory.resize(std::max<std::size_t>(here.conditions.size(), 1), 0);
  step.readings.clear();
  step.reading.reset();
  std::size_t met = 0;
  for (std::size_t i = 0; i < here.conditions.size(); ++i) {
    const Condition& condition = here.conditions[i];
    double value = 0;
    Looked looked = sense(condition, value);
    if (looked.stopped || !looked.problem.empty()) return looked;
    if (here.conditions.size() == 1) {
      step.reading = value;
    } else {
      const std::string subject = subject_text(condition);
      const auto before =
          std::count_if(here.conditions.begin(), here.conditions.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](const Condition& each) { return subject_text(each) == subject; });
      step.readings.push_back({before == 0 ? subject : fmt::format("{} ({})", subject, before + 1), value});
    }
    const double slack = memory[i] > 0 ? condition.hysteresis : 0;
    if (!here.limits.empty()) {
      std::size_t reached = 0;
      for (std::size_t k = 0; k < here.limits.size(); ++k)
        if (value >= bound(here.limits[k]) - (memory[i] > k ? condition.hysteresis : 0)) ++reached;
      memory[i] = reached;
      return {false, reached, {}};
    }
    const bool is_met = (!condition.at_least || value >= bound(*condition.at_least) - slack) &&
                        (!condition.at_most || value <= bound(*condition.at_most) + slack);
    memory[i] = is_met ? 1 : 0;
    met += memory[i];
  }
  const bool enough = here.combination == Combination::any ? met > 0 : met == here.conditions.size();
  return {false, enough ? std::size_t{1} : 0, {}};
}

void Executor::act_test() {
  const Icon& here = icon();
  Step step = new_step();
  announce(step);
  Looked looked;
  try {
    looked = look(here, step, memories_[icon_name()]);
  } catch (const MissingValue& problem) {
    looked.problem = problem.what();
  }
  if (looked.stopped) return cut_off(step);
  if (looked.problem.empty()) {
    step.result = {ResultKind::normal, static_cast<int>(looked.code), {}};
  } else {
    step.result = {ResultKind::error, no_value, looked.problem};
  }
  finish(step);
  leave_with(step.result.code, step.result.kind == ResultKind::normal, step.result.reason);
}

void Executor::act_wait() {
  const Icon& here = icon();
  std::optional<Duration> timeout;
  if (here.timeout) timeout = duration_of(number_of(*here.timeout, 0, longest_time, "a time"));
  Step step = new_step();
  announce(step);
  Memory memory;
  for (bool over = false; !over;) {
    Looked looked;
    try {
      looked = look(here, step, memory);
    } catch (const MissingValue& problem) {
      looked.problem = problem.what();
    }
    if (looked.stopped || pausing()) return cut_off(step);
    over = true;
    if (!looked.problem.empty()) {
      step.result = {ResultKind::error, no_value, looked.problem};
    } else if (looked.code == 1) {
      step.result = {ResultKind::normal, 0, {}};
    } else if (timeout && runner_.now() - step.begin >= *timeout) {
      step.result = {ResultKind::contingency, waited_in_vain, "the time is over"};
    } else if (!runner_.delay(between_readings)) {
      return cut_off(step);
    } else {
      over = false;
    }
  }
  finish(step);
  leave_with(step.result.code, step.result.kind == ResultKind::normal, step.result.reason);
}

/// Also of a planned skill: a person does it, and says how it ended.
void Executor::act_question() {
  const Icon& here = icon();
  std::optional<Duration> timeout;
  if (here.timeout) timeout = duration_of(number_of(*here.timeout, 0, longest_time, "a time"));
  Step step = new_step();
  announce(step);
  Question question{step.icon, step.question, {}};
  for (const Way& answer : here.ways) question.answers.push_back(answer.text);
  runner_.ask(question);
  for (bool over = false; !over;) {
    const Reply reply = runner_.answer();
    over = true;
    if (reply.stopped || pausing()) {
      runner_.withdraw();
      return cut_off(step);
    }
    if (reply.choice && *reply.choice < here.ways.size()) {
      step.answer = question.answers[*reply.choice];
      const int code = here.ways[*reply.choice].codes.front();
      const bool normal = here.kind == IconKind::question || code == 0;
      step.result = {normal ? ResultKind::normal : ResultKind::contingency, code, {}};
    } else if (!reply.problem.empty()) {
      step.result = {ResultKind::error, no_value, reply.problem};
    } else if (timeout && runner_.now() - step.begin >= *timeout) {
      step.result = {ResultKind::contingency, time_over, "nobody answered in time"};
    } else if (!runner_.delay(between_readings)) {
      runner_.withdraw();
      return cut_off(step);
    } else {
      over = false;
    }
  }
  runner_.withdraw();
  finish(step);
  const bool normal = step.result.kind == ResultKind::normal;
  if (normal && here.kind == IconKind::planned) ++counts_[icon_name()];
  leave_with(step.result.code, normal, step.result.reason);
}

}  // namespace pal::operations
