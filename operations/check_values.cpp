#include "operations/check_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "operations/cure.hpp"
#include "operations/fields.hpp"
#include "pal/support/finding.hpp"

namespace pal::operations {
namespace {

bool is_number(const pan::Parameter& parameter) {
  return parameter.type == pan::ScalarType::real || parameter.type == pan::ScalarType::integer;
}

bool can_be_typed(char c) {
  return c >= ' ' && c <= '~';
}

bool fits(const pan::Parameter& wanted, const Value& value) {
  if (wanted.type == pan::ScalarType::boolean) return std::holds_alternative<bool>(value);
  if (wanted.type == pan::ScalarType::text) {
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr && text->size() <= pan::longest_text &&
           std::all_of(text->begin(), text->end(), can_be_typed);
  }
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr || !(*number >= wanted.low && *number <= wanted.high)) return false;
  return wanted.type == pan::ScalarType::real || std::floor(*number) == *number;
}

/// Whether every value of the argument is one of `wanted`.
bool fits(const pan::Parameter& wanted, const pan::Parameter& argument) {
  if (!is_number(wanted)) return wanted.type == argument.type;
  if (!is_number(argument) || argument.unit != wanted.unit) return false;
  if (wanted.type == pan::ScalarType::integer && argument.type != pan::ScalarType::integer) return false;
  return argument.low >= wanted.low && argument.high <= wanted.high;
}

class ValueChecks {
 public:
  ValueChecks(const Graph& graph, Place at, const Icon& icon, Suggestions& suggestions,
              Diagnostics& diagnostics)
      : graph_(graph),
        at_(at),
        operation_(graph.program().operations[at.operation]),
        icon_(icon),
        suggestions_(suggestions),
        diagnostics_(diagnostics) {}

  void check() {
    for (const Parameter& parameter : icon_.parameters) check_source(parameter.source, parameter.where);
    check_amount(icon_.repeat, "'repeat'", {0, 1e6, true, "", ""});
    check_amount(icon_.time_limit, "'time-limit'", {0.001, longest_time, false, "", "s"});
    check_amount(icon_.seconds, "'seconds'", {0, longest_time, false, "", "s"});
    check_amount(icon_.timeout, "'timeout'", {0, longest_time, false, "", "s"});
    check_amount(icon_.code, "a completion code", {-1e6, 1e6, true, "", ""});
    for (const Amount& limit : icon_.limits) check_number(limit, "a limit");
    for (const Condition& condition : icon_.conditions) {
      if (condition.sensor.empty()) check_number(condition.value, "what is compared");
      if (condition.at_least) check_number(*condition.at_least, "'at-least'");
      if (condition.at_most) check_number(*condition.at_most, "'at-most'");
    }
    if (icon_.breakpoint && icon_.breakpoint->condition)
      check_source(icon_.breakpoint->condition->source, icon_.breakpoint->where);
    if (icon_.kind == IconKind::sub_operation) check_arguments();
  }

 private:
  void report_no_icon(const Source& source, SourceSpan where, FindingWith<2> finding) {
    std::vector<std::string> ids;
    for (const Icon& each : operation_.icons) ids.push_back(each.id);
    auto near = suggestions_.nearest_to(source.icon, ids);
    if (near == source.icon) near.reset();
    diagnostics_.report(finding, where, operation_.name, source.icon).suggest(near);
  }

  bool check_source(const Source& source, SourceSpan where) {
    if (source.written()) return true;
    if (source.kind == Source::Kind::argument) {
      if (find_argument(operation_, source.name) != nullptr) return true;
      std::vector<std::string> names;
      for (const pan::Parameter& each : operation_.arguments) names.push_back(each.name);
      diagnostics_
          .report(Finding::argument_not_declared, where, operation_.name, source.name,
                  names.empty() ? "declare it under \"arguments\" of the operation"
                                : fmt::format("it has {}", fmt::join(names, ", ")))
          .suggest(suggestions_.nearest_to(source.name, names));
      return false;
    }
    const auto found = graph_.find(at_.operation, source.icon);
    const IconKind kind = found ? graph_.icon({at_.operation, *found}).kind : IconKind::merge;
    const bool counts = source.kind == Source::Kind::count;
    if (kind == IconKind::skill || (counts && (kind == IconKind::sub_operation || kind == IconKind::planned)))
      return true;
    report_no_icon(source, where, either<Finding::no_skill_to_count, Finding::no_skill_to_report>(counts));
    return false;
  }

  void check_number(const Amount& amount, const char* what) { check_range(amount, what, any_number); }
  void check_amount(const std::optional<Amount>& amount, const char* what, const Range& range) {
    if (amount) check_range(*amount, what, range);
  }
  void check_range(const Amount& amount, const char* what, const Range& range) {
    if (!check_source(amount.source, amount.where) || amount.source.kind != Source::Kind::argument) return;
    const pan::Parameter& argument = *find_argument(operation_, amount.source.name);
    pan::Parameter wanted;
    wanted.type = range.whole ? pan::ScalarType::integer : pan::ScalarType::real;
    wanted.low = range.low;
    wanted.high = range.high;
    // What a sensor is compared with has the sensor's unit, which only a cell knows.
    wanted.unit = range.low == any_number.low ? argument.unit : range.unit;
    if (fits(wanted, argument)) return;
    diagnostics_.report(Finding::argument_does_not_fit, amount.where, what, argument.name,
                        type_text(argument), wanted.low == any_number.low ? "a number" : type_text(wanted));
  }

  void check_arguments() {
    const auto sub = graph_.sub_operation(at_);
    if (!sub) return;
    const Operation& inside = graph_.program().operations[*sub];
    for (const Parameter& given : icon_.parameters) {
      if (const pan::Parameter* wanted = find_argument(inside, given.name)) {
        check_fit(*wanted, given, operation_, fmt::format("operation '{}'", inside.name), diagnostics_);
        continue;
      }
      std::vector<std::string> names;
      for (const pan::Parameter& each : inside.arguments) names.push_back(each.name);
      const auto near = suggestions_.nearest_to(given.name, names);
      diagnostics_
          .report(Finding::no_such_argument, given.name_where, inside.name, given.name,
                  names.empty() ? "none; declare it under its \"arguments\""
                                : fmt::format("{}", fmt::join(names, ", ")))
          .suggest(near)
          .fix = renamed(given.name_where, near);
    }
  }

  const Graph& graph_;
  Place at_;
  const Operation& operation_;
  const Icon& icon_;
  Suggestions& suggestions_;
  Diagnostics& diagnostics_;
};

}  // namespace

const pan::Parameter* find_argument(const Operation& operation, const std::string& name) {
  for (const pan::Parameter& each : operation.arguments)
    if (each.name == name) return &each;
  return nullptr;
}

std::string type_text(const pan::Parameter& parameter) {
  switch (parameter.type) {
    case pan::ScalarType::text:
      return "a text in double quotes";
    case pan::ScalarType::boolean:
      return "true or false";
    case pan::ScalarType::integer:
      return fmt::format("a whole number from {} to {}", parameter.low, parameter.high);
    case pan::ScalarType::real:
      break;
  }
  return fmt::format("a number from {} to {}{}{}", parameter.low, parameter.high,
                     parameter.unit.empty() ? "" : " ", parameter.unit);
}

bool check_fit(const pan::Parameter& wanted, const Parameter& given, const Operation& operation,
               const std::string& owner, Diagnostics& diagnostics) {
  const pan::Parameter* argument =
      given.source.kind == Source::Kind::argument ? find_argument(operation, given.source.name) : nullptr;
  bool fit = true;
  if (given.source.written()) {
    fit = fits(wanted, given.value);
  } else if (argument != nullptr) {
    fit = fits(wanted, *argument);
  } else if (given.source.kind != Source::Kind::argument) {
    fit = is_number(wanted);
  }
  if (fit) return true;
  argument == nullptr ? diagnostics.report(Finding::value_does_not_fit, given.where, given.name, owner,
                                           to_text(given), type_text(wanted))
                      : diagnostics.report(Finding::given_argument_does_not_fit, given.where, given.name,
                                           owner, to_text(given), type_text(*argument), type_text(wanted));
  return false;
}

void check_values(const Graph& graph, Place at, const Icon& icon, Suggestions& suggestions,
                  Diagnostics& diagnostics) {
  ValueChecks(graph, at, icon, suggestions, diagnostics).check();
}

}  // namespace pal::operations
