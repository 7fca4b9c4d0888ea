// Commands that run, halt and change the operation, and skills alone.
#include <fmt/format.h>

#include <algorithm>

#include "server/desk_parts.hpp"
#include "server/program_check.hpp"

namespace pal::server {

using operations::ExecutionState;
using operations::Executor;

namespace {

constexpr std::size_t most_breakpoints = 1000;

/// Whether the icon lets an operator set the parameter to this value.
std::optional<Refusal> operator_may_not(const operations::Icon& icon, const SetParameter& command) {
  const auto& allowed = icon.operator_may_set;
  const auto found = std::find_if(
      allowed.begin(), allowed.end(),
      [&](const operations::OperatorMaySet& each) { return each.parameter == command.parameter; });
  const TextPlace place{{}, {}, command.icon, "parameters/" + command.parameter};
  if (found == allowed.end())
    return Refusal{Refusal::Why::role,
                   fmt::format("an operator may not set '{}' of '{}'", command.parameter, command.icon),
                   "a programmer may, or lets operators do it in the operation's file", place};
  const auto* number = std::get_if<double>(&command.value);
  if (number == nullptr) return std::nullopt;
  const double low = found->from.value_or(-std::numeric_limits<double>::infinity());
  const double high = found->to.value_or(std::numeric_limits<double>::infinity());
  if (*number >= low && *number <= high) return std::nullopt;
  Refusal refusal{Refusal::Why::role,
                  fmt::format("an operator may set '{}' of '{}' only from {} to {}", command.parameter,
                              command.icon, low, high),
                  "a programmer may set other values", place};
  if (found->from && found->to) refusal.limits = {low, high};
  return refusal;
}

}  // namespace

void Desk::Parts::tell_halt(const std::string& by) {
  publish(HaltAsked{status.pausing, status.stopping, by});
}

void Desk::Parts::pause(const std::string& by) {
  ++pauses;
  executor->pause();
  if (!std::exchange(status.pausing, true)) tell_halt(by);
}

void Desk::Parts::stop(const std::string& by) {
  if (status.activity == Activity::idle) {
    if (!executor || executor->state() != ExecutionState::paused) return;
    executor->end_pause();
    look_at_executor();
    if (options.runs != nullptr && operation_run != 0)
      options.runs->change(operation_run, operations::name(status.state), time_now(), std::nullopt,
                           status.reason);
    publish_state();
    return;
  }
  ++stops;
  if (status.activity == Activity::operation) {
    executor->stop();
  } else {
    runner.stop();
  }
  if (!std::exchange(status.stopping, true)) tell_halt(by);
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, Pause&) {
  if (status.activity == Activity::skill)
    return Refusal{Refusal::Why::nothing, "a skill that runs alone cannot pause; stop ends it"};
  if (status.activity != Activity::operation) return Refusal{Refusal::Why::nothing, "nothing runs"};
  pause(name_of(asked.client));
  return std::nullopt;
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, Stop&) {
  stop(name_of(asked.client));
  return std::nullopt;
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, RunSkill& command) {
  if (auto refusal = need_controls(asked.client)) return refusal;
  if (auto refusal = need_rest()) return refusal;
  if (auto refusal = need_no_hold()) return refusal;
  if (auto refusal = mistake_in(command, cell)) return refusal;
  give_controls(asked.client);
  begin(Activity::skill);
  note_begin(RunRecord::Kind::skill, command.skill, asked.client);
  stops_without.reset();
  if (!command.goes_on) stops_without = asked.client;
  skill_job = SkillJob{std::move(command), asked.client, std::exchange(asked.answer, nullptr)};
  return std::nullopt;
}

Desk::Parts::Result Desk::Parts::obey(Asked&, LoadOperation&) {
  return Refusal{Refusal::Why::wrong, "an operation is checked before it is loaded"};
}

Desk::Parts::Result Desk::Parts::load(Asked& asked, LoadOperation command, const operations::Stop& stop) {
  const auto allowed = [&]() -> Result {
    if (auto refusal = need_role(asked, command)) return refusal;
    if (auto refusal = need_controls(asked.client)) return refusal;
    return need_rest();
  };
  std::shared_ptr<const operations::Cell> known;
  {
    const std::lock_guard lock(mutex);
    if (auto refusal = allowed()) return refusal;
    known = known_cell();
  }
  std::variant<operations::Program, Refusal> read = program_of(command, *known, stop);
  if (auto* refusal = std::get_if<Refusal>(&read)) return std::move(*refusal);
  // A large operation takes a while to be made ready, and the one before it to be forgotten: neither is done
  // with the lock, which a stop needs.
  auto next =
      std::make_unique<Executor>(std::move(std::get<operations::Program>(read)), asking_runner, this, &cell);
  next->add_kept_breakpoints(most_breakpoints);
  std::shared_ptr<const LoadedFiles> files = std::make_shared<LoadedFiles>(
      LoadedFiles{std::move(command.files), std::move(command.main), std::move(command.stored)});
  decltype(icons) icons_before;
  const Locked lock(*this);
  if (auto refusal = allowed()) return refusal;
  give_controls(asked.client);
  executor.swap(next);
  loaded.swap(files);
  changes.clear();
  icons.swap(icons_before);
  forget_icons();
  look_at_executor();
  asked.done.operation = status.operation;
  publish(OperationLoaded{status.operation, name_of(asked.client)});
  if (!breakpoints.empty()) publish(BreakpointsChanged{breakpoints, name_of(asked.client)});
  return std::nullopt;
}

void Desk::Parts::forget_icons() {
  icons.clear();
  here.reset();
  step_before.clear();
  cut_off = false;
  operation_run = 0;
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, RunOperation& command) {
  if (auto refusal = need_controls(asked.client)) return refusal;
  if (auto refusal = need_rest()) return refusal;
  if (auto refusal = need_operation()) return refusal;
  const ExecutionState state = executor->state();
  if (command.how == RunOperation::How::resume && state != ExecutionState::paused &&
      state != ExecutionState::stopped)
    return Refusal{Refusal::Why::nothing,
                   fmt::format("the operation is {}, neither paused nor stopped; 'run' begins it",
                               operations::name(state))};
  if (auto refusal = need_no_hold()) return refusal;
  if (state == ExecutionState::ended || state == ExecutionState::failed) start_again();
  give_controls(asked.client);
  begin(Activity::operation);
  if (operation_run == 0) {
    note_begin(RunRecord::Kind::operation, status.operation, asked.client);
    operation_run = status.run;
  } else if (options.runs != nullptr) {
    status.run = operation_run;
    options.runs->change(operation_run, "running", std::nullopt, std::nullopt, "");
    if (options.recording != nullptr) options.recording->begin(operation_run, time_now());
  }
  operation_job = OperationJob{command.how == RunOperation::How::step ? std::size_t{1} : 0};
  status.state = ExecutionState::running;
  status.reason.clear();
  publish_state();
  return std::nullopt;
}

void Desk::Parts::start_again() {
  forget_icons();
  for (const operations::Icon& icon : executor->program().operations.front().icons)
    if (icon.kind == operations::IconKind::start) return executor->start_from(icon.id);
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, PutToken& command) {
  if (auto refusal = need_controls(asked.client)) return refusal;
  if (auto refusal = need_rest()) return refusal;
  if (auto refusal = need_operation()) return refusal;
  executor->start_from(command.icon);
  give_controls(asked.client);
  forget_icons();
  look_at_executor();
  here = Here{status.token, time_now(), std::chrono::system_clock::now()};
  publish_state();
  return std::nullopt;
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, SetParameter& command) {
  if (auto refusal = need_controls(asked.client)) return refusal;
  if (auto refusal = need_rest()) return refusal;
  if (auto refusal = need_operation()) return refusal;
  const auto path = operations::find_path(executor->program(), command.icon);
  if (!path.empty() && clients.at(asked.client).role == Role::operating) {
    const operations::Place at = path.back();
    if (auto refusal = operator_may_not(executor->program().operations[at.operation].icons[at.icon], command))
      return refusal;
  }
  const auto given = executor->parameter(command.icon, command.parameter);
  std::optional<operations::Value> before;
  if (given && given->source.written()) before = given->value;
  executor->set_parameter(command.icon, command.parameter, command.value);
  give_controls(asked.client);
  asked.done.before = before;
  const std::string& by = name_of(asked.client);
  const std::pair at(command.icon, command.parameter);
  const auto known = changes.find(at);
  const auto in_file = known == changes.end() ? before : known->second.before;
  if (in_file == command.value) {
    changes.erase(at);
  } else {
    changes[at] = {command.value, in_file, by};
  }
  publish(ParameterSet{command.icon, command.parameter, std::move(command.value), before, by});
  return std::nullopt;
}

void Desk::Parts::tell_breakpoints(const std::string& by) {
  breakpoints = executor->breakpoints();
  publish(BreakpointsChanged{breakpoints, by});
}

Desk::Parts::Result Desk::Parts::change_breakpoints(Asked& asked, std::function<Reply()> change) {
  if (auto refusal = need_controls(asked.client)) return refusal;
  if (auto refusal = need_operation()) return refusal;
  if (status.activity == Activity::operation) {
    between.emplace_back(std::move(change), std::exchange(asked.answer, nullptr));
  } else {
    Reply reply = change();
    if (auto* refusal = std::get_if<Refusal>(&reply)) return std::move(*refusal);
    asked.done = std::move(std::get<Done>(reply));
  }
  give_controls(asked.client);
  return std::nullopt;
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, SetBreakpoint& command) {
  return change_breakpoints(
      asked, [this, wanted = command.breakpoint, by = name_of(asked.client)]() mutable -> Reply {
        const auto& all = executor->breakpoints();
        const auto found = std::find_if(all.begin(), all.end(), [&](const operations::Breakpoint& each) {
          return each.number == wanted.number;
        });
        if (wanted.number != 0 && found == all.end())
          return Refusal{Refusal::Why::absent, fmt::format("there is no breakpoint {}", wanted.number),
                         "operation.breakpoints lists them"};
        if (found == all.end() && all.size() >= most_breakpoints)
          return Refusal{Refusal::Why::too_much, fmt::format("there are {} breakpoints", all.size()),
                         "remove some first"};
        Done done;
        done.breakpoint = executor->add_breakpoint(std::move(wanted));
        tell_breakpoints(by);
        return done;
      });
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, RemoveBreakpoint& command) {
  return change_breakpoints(asked, [this, number = command.number, by = name_of(asked.client)]() -> Reply {
    if (!executor->remove_breakpoint(number))
      return Refusal{Refusal::Why::absent, fmt::format("there is no breakpoint {}", number),
                     "operation.breakpoints lists them"};
    tell_breakpoints(by);
    return Done{};
  });
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, ClearBreakpoints&) {
  return change_breakpoints(asked, [this, by = name_of(asked.client)]() -> Reply {
    executor->clear_breakpoints();
    tell_breakpoints(by);
    return Done{};
  });
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, AnswerQuestion& command) {
  if (auto refusal = need_controls(asked.client)) return refusal;
  if (!status.question || status.question->question.icon != command.icon || answer)
    return Refusal{Refusal::Why::nothing, fmt::format("'{}' asks nothing now", command.icon)};
  const auto& answers = status.question->question.answers;
  std::optional<std::size_t> choice;
  if (const auto* number = std::get_if<std::size_t>(&command.answer)) {
    if (*number < answers.size()) choice = *number;
  } else {
    const auto found = std::find(answers.begin(), answers.end(), std::get<std::string>(command.answer));
    if (found != answers.end()) choice = static_cast<std::size_t>(found - answers.begin());
  }
  if (!choice)
    return Refusal{Refusal::Why::wrong, fmt::format("'{}' has no such answer", command.icon),
                   fmt::format("there are {}, from 0", answers.size())};
  give_controls(asked.client);
  answer = *choice;
  answered_by = name_of(asked.client);
  answered.notify_all();
  return std::nullopt;
}

}  // namespace pal::server
