#include "server/outlook.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "operations/graph.hpp"
#include "operations/missing_value.hpp"

namespace pal::server {
namespace {

using operations::ExecutionState;
using operations::Icon;
using operations::IconKind;

// The token passes no more icons than this on its way to the first skill.
constexpr std::size_t longest_look = 1000;

/// The first skill that runs when the token is before the icon; nothing: it depends, or there is none.
const Icon* first_skill(const operations::Graph& graph, operations::Place at) {
  for (std::size_t i = 0; i < longest_look; ++i) {
    const Icon& icon = graph.icon(at);
    if (icon.kind == IconKind::skill) return &icon;
    std::optional<std::size_t> next;
    if (icon.kind == IconKind::sub_operation) {
      const auto sub = graph.sub_operation(at);
      if (!sub) return nullptr;
      const auto start = graph.start(*sub);
      if (!start) return nullptr;
      at = {*sub, *start};
      continue;
    }
    if (icon.kind == IconKind::restart) {
      next = graph.start(at.operation);
    } else if (icon.kind == IconKind::start || icon.kind == IconKind::merge || icon.kind == IconKind::delay) {
      next = graph.target(at.operation, icon.next);
    }
    if (!next) return nullptr;
    at.icon = *next;
  }
  return nullptr;
}

operations::Place place_of(const operations::Executor& executor, const std::string& icon) {
  const auto path = operations::find_path(executor.program(), icon);
  if (path.empty()) throw operations::ExecutionError(fmt::format("there is no icon '{}'", icon));
  return path.back();
}

std::string in_words(const Choice& choice) {
  std::string text = choice.repeats ? fmt::format("'{}' begins again from its beginning", choice.icon)
                                    : fmt::format("goes on before '{}'", choice.icon);
  if (!choice.skill.empty()) {
    std::vector<std::string> values;
    for (const operations::Parameter& each : choice.parameters)
      values.push_back(fmt::format("{} {}", each.name, operations::to_text(each)));
    text += fmt::format("; the first skill is {}{}{}", choice.skill, values.empty() ? "" : " with ",
                        fmt::join(values, ", "));
  }
  if (!choice.preconditions.empty())
    text += "; this must be so: " + fmt::format("{}", fmt::join(choice.preconditions, " "));
  if (choice.forgets) text += "; counts and figures are forgotten";
  return text;
}

}  // namespace

Outlook outlook_of(const operations::Executor& executor, const operations::Skills& skills,
                   const std::string& before, bool cut_off, const std::string& asked) {
  Outlook result{executor.state(), executor.token(), executor.reason(), {}};
  const operations::Graph graph(executor.program());
  const auto add = [&](const std::string& icon, Choice::Where where, const char* method) {
    Choice choice{icon, where, method};
    const bool here = where == Choice::Where::here;
    choice.repeats = here && cut_off && result.state != ExecutionState::ended;
    choice.forgets = !here && result.state != ExecutionState::ready;
    if (const Icon* first = first_skill(graph, place_of(executor, icon))) {
      choice.skill = first->skill;
      choice.parameters = first->parameters;
      if (const auto found = skills.find(first->skill); found != skills.end())
        choice.preconditions = found->second.preconditions;
    }
    choice.text = in_words(choice);
    result.choices.push_back(std::move(choice));
  };
  const bool over = result.state == ExecutionState::ended || result.state == ExecutionState::failed;
  const char* go_on = result.state == ExecutionState::ready ? "operation.run" : "operation.resume";
  if (!asked.empty()) {
    const bool here = asked == result.token && !over;
    add(asked, here ? Choice::Where::here : Choice::Where::other, here ? go_on : "operation.from");
    return result;
  }
  if (!over) add(result.token, Choice::Where::here, go_on);
  if (result.state == ExecutionState::failed) add(result.token, Choice::Where::other, "operation.from");
  if (!before.empty() && before != result.token && !operations::find_path(executor.program(), before).empty())
    add(before, Choice::Where::before, "operation.from");
  for (const Icon& icon : executor.program().operations.front().icons)
    if (icon.kind == IconKind::start && icon.id != result.token)
      add(icon.id, Choice::Where::start, over ? "operation.run" : "operation.from");
  return result;
}

IconValues values_of(const operations::Executor& executor, const operations::Skills& skills,
                     const std::string& icon) {
  const operations::Place at = place_of(executor, icon);
  const Icon& shown = executor.program().operations[at.operation].icons[at.icon];
  IconValues result{icon, shown.skill, {}};
  const auto add = [&](const pan::Parameter& parameter) {
    IconValue value{parameter.name};
    const auto given =
        std::find_if(shown.parameters.begin(), shown.parameters.end(),
                     [&](const operations::Parameter& each) { return each.name == parameter.name; });
    value.set = given != shown.parameters.end();
    if (!value.set) {
      value.value = operations::default_of(parameter);
    } else if (given->source.written()) {
      value.value = given->value;
    } else {
      value.source = given->source;
    }
    for (const operations::OperatorMaySet& each : shown.operator_may_set)
      if (each.parameter == parameter.name)
        value.limits = {each.from.value_or(parameter.low), each.to.value_or(parameter.high)};
    result.values.push_back(std::move(value));
  };
  if (shown.kind == IconKind::skill) {
    if (const auto found = skills.find(shown.skill); found != skills.end())
      for (const pan::Parameter& each : found->second.parameters) add(each);
  } else if (shown.kind == IconKind::sub_operation) {
    const operations::Graph graph(executor.program());
    if (const auto sub = graph.sub_operation(at))
      for (const pan::Parameter& each : executor.program().operations[*sub].arguments) add(each);
  } else {
    throw operations::ExecutionError(fmt::format("'{}' is no skill", icon));
  }
  return result;
}

}  // namespace pal::server
