#include "operations/parse_icon.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "operations/codes.hpp"
#include "operations/fields.hpp"
#include "operations/parse_argument.hpp"
#include "pal/support/finding.hpp"

namespace pal::operations {
namespace {

using Kind = JsonValue::Kind;

std::vector<Parameter> read_parameters(const JsonValue* object, Fields& fields, Diagnostics& diagnostics) {
  std::vector<Parameter> result;
  std::set<std::string> names;
  if (object == nullptr) return result;
  for (const JsonMember& member : object->members) {
    Parameter parameter{member.name, 0.0, member.value.where, member.where};
    switch (member.value.kind) {
      case Kind::number:
        parameter.value = member.value.number;
        break;
      case Kind::boolean:
        parameter.value = member.value.truth;
        break;
      case Kind::text:
        parameter.value = member.value.text;
        break;
      case Kind::object:
        parameter.source = read_source(member.value, diagnostics);
        if (parameter.source.written()) continue;
        break;
      default:
        fields.report(Finding::parameter_of_no_type, member.value.where);
        continue;
    }
    if (!names.insert(member.name).second) {
      fields.report(Finding::field_given_twice, member.where, member.name);
      continue;
    }
    result.push_back(std::move(parameter));
  }
  return result;
}

Way read_way(const JsonValue& value, Diagnostics& diagnostics) {
  Way way;
  way.where = value.where;
  Fields fields(value, diagnostics);
  if (value.kind != Kind::object) {
    fields.report(Finding::way_not_object, value.where);
    return way;
  }
  if (const JsonValue* codes = fields.find("codes", Kind::array, "a list of completion codes")) {
    for (const JsonValue& code : codes->items) {
      if (is_code(code)) {
        way.codes.push_back(static_cast<int>(code.number));
      } else {
        fields.report(Finding::code_not_whole, code.where);
      }
    }
    if (!codes->items.empty()) way.where = codes->items.front().where;
  }
  // A code that was refused is one finding, and no other.
  const JsonValue* given = fields.find("codes");
  if (way.codes.empty() && (given == nullptr || given->items.empty())) fields.missing("codes");
  way.to = fields.connection("to");
  fields.refuse_the_rest();
  return way;
}

void read_case(Icon& icon, Fields& fields, Diagnostics& diagnostics) {
  if (const JsonValue* ways = fields.find("ways", Kind::array, "a list of ways"))
    for (const JsonValue& way : ways->items) icon.ways.push_back(read_way(way, diagnostics));
  icon.otherwise = fields.connection("default");
  const std::size_t count = icon.ways.size() + (icon.otherwise.connected() ? 1 : 0);
  if ((count < 2 || icon.ways.size() > 4) && !fields.refused("ways") && !fields.refused("default"))
    fields.report(either<Finding::too_few_ways, Finding::too_many_ways>(count < 2), icon.where, count);
}

void read_limits(Icon& icon, const JsonValue& limits, Fields& fields, Diagnostics& diagnostics) {
  for (const JsonValue& limit : limits.items) {
    const auto amount = amount_of(limit, "limit", any_number, fields, diagnostics);
    if (!amount) continue;
    const bool comparable =
        !icon.limits.empty() && amount->source.written() && icon.limits.back().source.written();
    if (comparable && amount->number <= icon.limits.back().number) {
      fields.report(Finding::limit_not_above, limit.where, fmt::to_string(limit.number));
    } else {
      icon.limits.push_back(*amount);
    }
  }
  if (limits.items.empty() || limits.items.size() > 3)
    fields.report(Finding::number_of_limits, limits.where, limits.items.size());
}

/// What is read: a sensor, or a value that the operation knows; and how it is compared.
Condition read_condition(Fields& fields, Diagnostics& diagnostics) {
  Condition condition;
  condition.sensor = fields.text("sensor", &condition.subject);
  if (const JsonValue* value = fields.find("value", Kind::object, "a count, an argument or an output")) {
    condition.value = {0, value->where, read_source(*value, diagnostics)};
    condition.subject = value->where;
    if (!condition.sensor.empty()) fields.report(Finding::sensor_and_value, value->where);
    if (condition.value.source.written()) fields.refuse("value");
  }
  if (condition.sensor.empty() && condition.value.source.written() && !fields.refused("value"))
    fields.missing("sensor");
  condition.at_least = read_amount("at-least", any_number, fields, diagnostics);
  condition.at_most = read_amount("at-most", any_number, fields, diagnostics);
  if (condition.at_least && condition.at_most && condition.at_least->source.written() &&
      condition.at_most->source.written() && condition.at_least->number > condition.at_most->number)
    fields.report(Finding::at_least_more_than_at_most, condition.at_most->where);
  constexpr Range beyond{0, std::numeric_limits<double>::max(), false, "a number", ""};
  condition.hysteresis = read_number("hysteresis", beyond, fields, diagnostics).value_or(0);
  constexpr Range readings{1, 1000, true, "a number of readings", ""};
  condition.mean_of = static_cast<int>(read_number("mean-of", readings, fields, diagnostics).value_or(1));
  if (condition.sensor.empty() && condition.mean_of > 1)
    fields.report(Finding::mean_of_no_sensor, condition.subject);
  return condition;
}

/// `wanted`: what is missing if there is neither.
void need_bound(const Condition& condition, const char* wanted, Fields& fields) {
  if (condition.at_least || condition.at_most) return;
  if (!fields.refused("at-least") && !fields.refused("at-most")) fields.missing(wanted);
}

/// The conditions of a list, all or any of which must be met.
void read_conditions(Icon& icon, const JsonValue& list, Fields& fields, Diagnostics& diagnostics) {
  for (const JsonValue& each : list.items) {
    Fields inside(each, diagnostics);
    if (each.kind != Kind::object) {
      inside.report(Finding::condition_not_object, each.where);
      continue;
    }
    icon.conditions.push_back(read_condition(inside, diagnostics));
    need_bound(icon.conditions.back(), "at-least", inside);
    inside.refuse_the_rest();
  }
  if (list.items.size() < 2 || list.items.size() > 8)
    fields.report(either<Finding::too_many_conditions, Finding::too_few_conditions>(list.items.size() > 8),
                  list.where, list.items.size());
}

/// One condition in the icon itself, or several in a list. `limits`: of a test; they stand for a condition.
void read_what_is_read(Icon& icon, const JsonValue* limits, Fields& fields, Diagnostics& diagnostics) {
  const JsonValue* all = fields.find("all", Kind::array, "a list of conditions");
  const JsonValue* any = fields.find("any", Kind::array, "a list of conditions");
  if (all != nullptr || any != nullptr) {
    icon.combination = all != nullptr ? Combination::all : Combination::any;
    if ((all != nullptr && any != nullptr) || limits != nullptr)
      fields.report(Finding::several_conditions, icon.where);
    read_conditions(icon, all != nullptr ? *all : *any, fields, diagnostics);
    return;
  }
  if (fields.refused("all") || fields.refused("any")) return;
  icon.conditions.push_back(read_condition(fields, diagnostics));
  const Condition& only = icon.conditions.front();
  icon.subject = only.subject;
  if (limits == nullptr) {
    if (!fields.refused("limits"))
      need_bound(only, icon.kind == IconKind::test ? "limits" : "at-least", fields);
    return;
  }
  read_limits(icon, *limits, fields, diagnostics);
  if (only.at_least || only.at_most) fields.report(Finding::limits_and_bounds, limits->where);
}

void read_test(Icon& icon, Fields& fields, Diagnostics& diagnostics) {
  const JsonValue* limits = fields.find("limits", Kind::array, "a list of numbers");
  read_what_is_read(icon, limits, fields, diagnostics);
}

void read_wait(Icon& icon, Fields& fields, Diagnostics& diagnostics) {
  read_what_is_read(icon, nullptr, fields, diagnostics);
  icon.timeout = read_amount("timeout", any_time, fields, diagnostics);
}

Way read_answer(const JsonValue& value, int code, Diagnostics& diagnostics) {
  Way answer;
  answer.codes = {code};
  answer.where = value.where;
  Fields fields(value, diagnostics);
  if (value.kind != Kind::object) {
    fields.report(Finding::answer_not_object, value.where);
    return answer;
  }
  answer.text = fields.needed_text("text", &answer.where);
  answer.to = fields.connection("to");
  fields.refuse_the_rest();
  return answer;
}

void read_question(Icon& icon, Fields& fields, Diagnostics& diagnostics) {
  icon.text = fields.needed_text("text", &icon.subject);
  const JsonValue* answers = fields.find("answers", Kind::array, "a list of answers");
  if (answers == nullptr) fields.missing("answers");
  for (const JsonValue& each : answers == nullptr ? std::vector<JsonValue>{} : answers->items) {
    Way answer = read_answer(each, static_cast<int>(icon.ways.size()), diagnostics);
    const bool twice =
        !answer.text.empty() && std::any_of(icon.ways.begin(), icon.ways.end(),
                                            [&](const Way& before) { return before.text == answer.text; });
    if (twice) fields.report(Finding::answer_given_twice, answer.where, answer.text);
    icon.ways.push_back(std::move(answer));
  }
  if (answers != nullptr && (answers->items.empty() || answers->items.size() > 6))
    fields.report(either<Finding::no_answers, Finding::too_many_answers>(answers->items.empty()),
                  answers->where, answers->items.size());
  icon.timeout = read_amount("timeout", any_time, fields, diagnostics);
}

/// {"code": 1, "text": "The pin does not fit."}
Way read_code(const JsonValue& value, Diagnostics& diagnostics) {
  Way code;
  code.where = value.where;
  Fields fields(value, diagnostics);
  if (value.kind != Kind::object) {
    fields.report(Finding::planned_code_not_object, value.where);
    return code;
  }
  constexpr Range range{0, 1e6, true, "a completion code", ""};
  if (const auto number = read_number("code", range, fields, diagnostics)) {
    code.codes = {static_cast<int>(*number)};
  } else {
    fields.missing("code");
  }
  code.text = fields.needed_text("text", &code.where);
  fields.refuse_the_rest();
  return code;
}

void read_planned(Icon& icon, Fields& fields, Diagnostics& diagnostics) {
  icon.skill = fields.needed_text("skill", &icon.subject);
  constexpr std::size_t most_parameters = 64, most_codes = 8;
  icon.planned = read_arguments("arguments", most_parameters, "a planned skill", fields, diagnostics);
  const JsonValue* codes = fields.find("codes", Kind::array, "a list of completion codes");
  if (codes == nullptr) fields.missing("codes");
  for (const JsonValue& each : codes == nullptr ? std::vector<JsonValue>{} : codes->items) {
    Way code = read_code(each, diagnostics);
    const bool twice = std::any_of(icon.ways.begin(), icon.ways.end(), [&](const Way& before) {
      return (!code.codes.empty() && before.codes == code.codes) ||
             (!code.text.empty() && before.text == code.text);
    });
    if (twice) fields.report(Finding::planned_code_given_twice, code.where);
    if (!twice && !code.codes.empty()) icon.ways.push_back(std::move(code));
  }
  if (codes != nullptr && (codes->items.empty() || codes->items.size() > most_codes))
    fields.report(Finding::number_of_planned_codes, codes->where, most_codes, codes->items.size());
}

/// "break": {"code": 1, "count-of": "put", "at-least": 3, "every": 2, "enabled": false}; {} halts always.
void read_breakpoint(Icon& icon, Fields& fields, Diagnostics& diagnostics) {
  const JsonValue* given = fields.find("break", Kind::object, "an object: when the token halts here");
  if (given == nullptr) return;
  KeptBreakpoint result;
  result.where = given->where;
  Fields inside(*given, diagnostics);
  constexpr Range codes{-1e6, 1e6, true, "a completion code", ""};
  if (const auto code = read_number("code", codes, inside, diagnostics))
    result.code = static_cast<int>(*code);
  constexpr Range times{1, 1e6, true, "a whole number", ""};
  result.every = static_cast<std::size_t>(read_number("every", times, inside, diagnostics).value_or(1));
  const JsonValue* enabled = inside.find("enabled", Kind::boolean, "true or false");
  result.enabled = enabled == nullptr || enabled->truth;
  if (const JsonValue* value = inside.find("value", Kind::object, "a count, an argument or an output")) {
    BreakCondition condition{read_source(*value, diagnostics), {}, {}};
    condition.at_least = read_number("at-least", any_number, inside, diagnostics);
    condition.at_most = read_number("at-most", any_number, inside, diagnostics);
    const bool refused = inside.refused("at-least") || inside.refused("at-most");
    if (!refused && !condition.at_least && !condition.at_most) inside.missing("at-least");
    if (!condition.source.written()) result.condition = std::move(condition);
  }
  inside.refuse_the_rest();
  icon.breakpoint = std::move(result);
}

void read_parameters_and_repeat(Icon& icon, Fields& fields, Diagnostics& diagnostics) {
  icon.parameters = read_parameters(
      fields.find("parameters", Kind::object, "an object with a value a parameter"), fields, diagnostics);
  constexpr Range times{1, 1e6, true, "a whole number", ""};
  icon.repeat = read_amount("repeat", times, fields, diagnostics);
}

void read_skill(Icon& icon, Fields& fields, Diagnostics& diagnostics) {
  icon.skill = fields.needed_text("skill", &icon.subject);
  read_parameters_and_repeat(icon, fields, diagnostics);
  constexpr Range limit{0.001, longest_time, false, "a time", " s"};
  icon.time_limit = read_amount("time-limit", limit, fields, diagnostics);
  constexpr Range retries{1, 1000, true, "a whole number", ""};
  icon.retries = static_cast<int>(read_number("retries", retries, fields, diagnostics).value_or(0));
  const JsonValue* codes = fields.find("retry-on", Kind::array, "a list of completion codes");
  if (codes == nullptr) return;
  for (const JsonValue& code : codes->items) {
    if (is_code(code)) {
      icon.retry_on.push_back(static_cast<int>(code.number));
    } else {
      fields.report(Finding::code_not_whole, code.where);
    }
  }
  if (icon.retries == 0 && !fields.refused("retries"))
    fields.report(Finding::retry_on_without_retries, codes->where);
}

/// "operator": {"force": {"from": 2, "to": 10}, "place": {}}.
void read_operator(Icon& icon, Fields& fields, Diagnostics& diagnostics) {
  const JsonValue* allowed = fields.find("operator", Kind::object, "an object: what an operator may set");
  if (allowed == nullptr) return;
  for (const JsonMember& member : allowed->members) {
    if (member.value.kind != Kind::object) {
      fields.report(Finding::operator_limits_not_object, member.value.where);
      continue;
    }
    OperatorMaySet each{member.name, {}, {}, member.where};
    Fields limits(member.value, diagnostics);
    each.from = read_number("from", any_number, limits, diagnostics);
    each.to = read_number("to", any_number, limits, diagnostics);
    limits.refuse_the_rest();
    if (each.from && each.to && *each.from > *each.to)
      limits.report(Finding::limits_run_backwards, member.value.where, fmt::to_string(*each.from),
                    fmt::to_string(*each.to));
    icon.operator_may_set.push_back(std::move(each));
  }
}

void read_position(Icon& icon, Fields& fields) {
  const JsonValue* at = fields.find("at", Kind::array, "a pair of numbers, [x, y]");
  if (at == nullptr) return;
  if (at->items.size() != 2 || at->items[0].kind != Kind::number || at->items[1].kind != Kind::number) {
    fields.report(Finding::place_not_a_pair, at->where);
    return;
  }
  icon.at = Point{at->items[0].number, at->items[1].number};
}

}  // namespace

std::optional<Icon> read_icon(const JsonValue& value, std::string& id, Diagnostics& diagnostics) {
  Fields fields(value, diagnostics);
  if (value.kind != Kind::object) {
    fields.report(Finding::icon_not_object, value.where);
    return std::nullopt;
  }
  Icon icon;
  icon.where = value.where;
  icon.id = id = fields.needed_text("id", &icon.where);
  SourceSpan kind_where = value.where;
  const std::string kind = fields.needed_text("kind", &kind_where);
  const auto known = icon_kind(kind);
  if (!known) {
    if (!kind.empty())
      fields.report(Finding::unknown_kind_of_icon, kind_where, kind,
                    fmt::format("{}", fmt::join(icon_kind_names(), ", ")));
    return std::nullopt;
  }
  if (icon.id.empty() || icon.id.find('/') != std::string::npos) {
    if (!icon.id.empty()) fields.report(Finding::slash_in_icon_name, icon.where);
    return std::nullopt;
  }
  icon.kind = *known;
  switch (icon.kind) {
    case IconKind::skill:
      read_skill(icon, fields, diagnostics);
      break;
    case IconKind::branch:
      read_case(icon, fields, diagnostics);
      break;
    case IconKind::delay:
      icon.seconds = read_amount("seconds", any_time, fields, diagnostics);
      if (!icon.seconds) fields.missing("seconds");
      break;
    case IconKind::wait:
      read_wait(icon, fields, diagnostics);
      break;
    case IconKind::test:
      read_test(icon, fields, diagnostics);
      break;
    case IconKind::question:
      read_question(icon, fields, diagnostics);
      break;
    case IconKind::zero:
      icon.sensor = fields.needed_text("sensor", &icon.subject);
      break;
    case IconKind::planned:
      read_planned(icon, fields, diagnostics);
      break;
    case IconKind::sub_operation:
      icon.subject = icon.where;
      icon.file = fields.text("file", &icon.subject);
      icon.operation = fields.text("operation", &icon.subject);
      if (icon.file.empty() && icon.operation.empty() && !fields.refused("file")) fields.missing("operation");
      read_parameters_and_repeat(icon, fields, diagnostics);
      break;
    case IconKind::exit: {
      constexpr Range codes{-1e6, 1e6, true, "a completion code", ""};
      icon.code = read_amount("code", codes, fields, diagnostics);
      break;
    }
    default:
      break;
  }
  if (has_next(icon.kind)) icon.next = fields.connection("next");
  if (has_completions(icon.kind)) icon.error = fields.connection("error");
  if (icon.kind == IconKind::skill || icon.kind == IconKind::sub_operation)
    read_operator(icon, fields, diagnostics);
  read_position(icon, fields);
  read_breakpoint(icon, fields, diagnostics);
  icon.note = fields.text("note");
  fields.refuse_the_rest();
  return icon;
}

}  // namespace pal::operations
