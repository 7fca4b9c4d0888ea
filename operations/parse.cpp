#include "operations/parse.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "operations/codes.hpp"
#include "operations/json_value.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "pal/support/nearest.hpp"

namespace pal::operations {
namespace {

using Kind = JsonValue::Kind;

constexpr double longest_delay = 86'400;  // s

/// The fields of an object, each asked for once; a field that was not asked for is reported.
class Fields {
 public:
  Fields(const JsonValue& object, Diagnostics& diagnostics)
      : object_(object), diagnostics_(diagnostics), taken_(object.members.size(), false) {}

  const JsonValue* find(const std::string& name) {
    known_.push_back(name);
    const JsonValue* found = nullptr;
    for (std::size_t i = 0; i < object_.members.size(); ++i) {
      if (object_.members[i].name != name) continue;
      taken_[i] = true;
      if (found != nullptr)
        report(object_.members[i].where, fmt::format("'{}' is given twice", name), "keep one of the two");
      found = &object_.members[i].value;
    }
    return found;
  }
  const JsonValue* find(const std::string& name, Kind kind, const char* what) {
    const JsonValue* value = find(name);
    if (value == nullptr || value->kind == kind) return value;
    report(value->where, fmt::format("'{}' must be {}", name, what), fmt::format("write {} here", what));
    return nullptr;
  }
  std::string text(const std::string& name, SourceSpan* where = nullptr) {
    const JsonValue* value = find(name, Kind::text, "a text in double quotes");
    if (value == nullptr) return {};
    if (where != nullptr) *where = value->where;
    return value->text;
  }
  std::string needed_text(const std::string& name, SourceSpan* where = nullptr) {
    const std::string result = text(name, where);
    if (result.empty()) missing(name);
    return result;
  }
  Connection connection(const std::string& name) {
    Connection result;
    result.icon = text(name, &result.where);
    return result;
  }
  void missing(const std::string& name) {
    report(object_.where, fmt::format("the field '{}' is missing or empty", name),
           fmt::format("add \"{}\"", name));
  }
  void report(SourceSpan where, std::string message, std::string hint) {
    diagnostics_.report(Code::PAL1002, where, std::move(message), std::move(hint));
  }
  void refuse_the_rest() {
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      if (taken_[i]) continue;
      const JsonMember& member = object_.members[i];
      const auto near = nearest(member.name, known_);
      report(member.where, fmt::format("there is no field '{}' here", member.name),
             near ? fmt::format("did you mean '{}'?", *near)
                  : fmt::format("there can be {}", fmt::join(known_, ", ")));
    }
  }

 private:
  const JsonValue& object_;
  Diagnostics& diagnostics_;
  std::vector<bool> taken_;
  std::vector<std::string> known_;
};

bool is_code(const JsonValue& value) {
  return value.kind == Kind::number && value.whole && std::abs(value.number) <= 1e6;
}

/// {"count-of": "icon"}
std::string read_count(const JsonValue& object, Fields& fields) {
  if (object.members.size() == 1 && object.members[0].name == "count-of" &&
      object.members[0].value.kind == Kind::text && !object.members[0].value.text.empty())
    return object.members[0].value.text;
  fields.report(object.where, "a count has the field 'count-of' and no other",
                "write {\"count-of\": \"icon\"}");
  return {};
}

std::vector<Parameter> read_parameters(const JsonValue* object, Fields& fields) {
  std::vector<Parameter> result;
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
        parameter.count_of = read_count(member.value, fields);
        if (parameter.count_of.empty()) continue;
        break;
      default:
        fields.report(member.value.where, "a parameter is a number, true, false, a text or a count",
                      "write one of these");
        continue;
    }
    const auto before = std::find_if(result.begin(), result.end(),
                                     [&](const Parameter& each) { return each.name == member.name; });
    if (before != result.end()) {
      fields.report(member.where, fmt::format("'{}' is given twice", member.name), "keep one of the two");
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
    fields.report(value.where, "a way of a CASE is an object",
                  "write {\"codes\": [0], \"to\": \"icon\"} here");
    return way;
  }
  if (const JsonValue* codes = fields.find("codes", Kind::array, "a list of completion codes")) {
    for (const JsonValue& code : codes->items) {
      if (is_code(code)) {
        way.codes.push_back(static_cast<int>(code.number));
      } else {
        fields.report(code.where, "a completion code is a whole number", "write a whole number");
      }
    }
    if (!codes->items.empty()) way.where = codes->items.front().where;
  }
  if (way.codes.empty()) fields.missing("codes");
  way.to = fields.connection("to");
  fields.refuse_the_rest();
  return way;
}

void read_case(Icon& icon, Fields& fields, Diagnostics& diagnostics) {
  if (const JsonValue* ways = fields.find("ways", Kind::array, "a list of ways"))
    for (const JsonValue& way : ways->items) icon.ways.push_back(read_way(way, diagnostics));
  icon.otherwise = fields.connection("default");
  const std::size_t count = icon.ways.size() + (icon.otherwise.connected() ? 1 : 0);
  if (count < 2 || icon.ways.size() > 4)
    fields.report(icon.where, fmt::format("a CASE has two to four ways, this one has {}", count),
                  count < 2 ? "add a way or a default; with a single way no CASE is needed"
                            : "put a second CASE behind the default");
}

void read_delay(Icon& icon, Fields& fields) {
  const JsonValue* seconds = fields.find("seconds", Kind::number, "a number of seconds");
  if (seconds == nullptr) {
    fields.missing("seconds");
  } else if (!(seconds->number >= 0 && seconds->number <= longest_delay)) {
    fields.report(seconds->where, "a delay lasts 0 to 86400 s", "write a number from 0 to 86400");
  } else {
    icon.seconds = seconds->number;
  }
}

void read_limits(Icon& icon, Fields& fields) {
  const JsonValue* limits = fields.find("limits", Kind::array, "a list of numbers");
  if (limits == nullptr) return fields.missing("limits");
  for (const JsonValue& limit : limits->items) {
    if (limit.kind != Kind::number) {
      fields.report(limit.where, "a limit is a number", "write a number, in the sensor's unit");
    } else if (!icon.limits.empty() && limit.number <= icon.limits.back()) {
      fields.report(limit.where, fmt::format("limit {} is not above the one before it", limit.number),
                    "write the limits in ascending order");
    } else {
      icon.limits.push_back(limit.number);
    }
  }
  if (limits->items.empty() || limits->items.size() > 3)
    fields.report(limits->where,
                  fmt::format("a test has one to three limits, this one has {}", limits->items.size()),
                  "each limit adds a code; a CASE has at most four ways");
}

std::optional<double> read_number(const char* name, Fields& fields) {
  const JsonValue* value = fields.find(name, Kind::number, "a number");
  if (value == nullptr) return std::nullopt;
  return value->number;
}

void read_condition(Icon& icon, Fields& fields) {
  icon.at_least = read_number("at-least", fields);
  icon.at_most = read_number("at-most", fields);
  if (!icon.at_least && !icon.at_most) fields.missing("at-least");
  if (icon.at_least && icon.at_most && *icon.at_least > *icon.at_most)
    fields.report(icon.where, "a wait for at least more than at most never ends",
                  "exchange 'at-least' and 'at-most'");
  const JsonValue* timeout = fields.find("timeout", Kind::number, "a number of seconds");
  if (timeout == nullptr) return;
  if (timeout->number >= 0 && timeout->number <= longest_delay) {
    icon.timeout = timeout->number;
  } else {
    fields.report(timeout->where, "a wait lasts 0 to 86400 s", "write a number from 0 to 86400");
  }
}

void read_position(Icon& icon, Fields& fields) {
  const JsonValue* at = fields.find("at", Kind::array, "a pair of numbers, [x, y]");
  if (at == nullptr) return;
  if (at->items.size() != 2 || at->items[0].kind != Kind::number || at->items[1].kind != Kind::number) {
    fields.report(at->where, "'at' must be a pair of numbers, [x, y]", "write two numbers");
    return;
  }
  icon.at = Point{at->items[0].number, at->items[1].number};
}

std::optional<Icon> read_icon(const JsonValue& value, Diagnostics& diagnostics) {
  Fields fields(value, diagnostics);
  if (value.kind != Kind::object) {
    fields.report(value.where, "an icon is an object", "write {\"id\": …, \"kind\": …} here");
    return std::nullopt;
  }
  Icon icon;
  icon.where = value.where;
  icon.id = fields.needed_text("id", &icon.where);
  SourceSpan kind_where = value.where;
  const std::string kind = fields.needed_text("kind", &kind_where);
  const auto known = icon_kind(kind);
  if (!known) {
    if (!kind.empty())
      fields.report(kind_where, fmt::format("there is no kind of icon '{}'", kind),
                    fmt::format("there is {}", fmt::join(icon_kind_names(), ", ")));
    return std::nullopt;
  }
  if (icon.id.empty() || icon.id.find('/') != std::string::npos) {
    if (!icon.id.empty())
      fields.report(icon.where, "an id has no '/'",
                    "'/' stands between the ids of a sub-operation and its icon");
    return std::nullopt;
  }
  icon.kind = *known;
  switch (icon.kind) {
    case IconKind::skill:
      icon.skill = fields.needed_text("skill", &icon.subject);
      icon.parameters = read_parameters(
          fields.find("parameters", Kind::object, "an object with a value a parameter"), fields);
      break;
    case IconKind::branch:
      read_case(icon, fields, diagnostics);
      break;
    case IconKind::delay:
      read_delay(icon, fields);
      break;
    case IconKind::wait:
      icon.sensor = fields.needed_text("sensor", &icon.subject);
      read_condition(icon, fields);
      break;
    case IconKind::test:
      icon.sensor = fields.needed_text("sensor", &icon.subject);
      read_limits(icon, fields);
      break;
    case IconKind::sub_operation:
      icon.subject = icon.where;
      icon.file = fields.text("file", &icon.subject);
      icon.operation = fields.text("operation", &icon.subject);
      if (icon.file.empty() && icon.operation.empty()) fields.missing("operation");
      break;
    case IconKind::exit:
      if (const JsonValue* code = fields.find("code")) {
        if (is_code(*code)) {
          icon.code = static_cast<int>(code->number);
        } else {
          fields.report(code->where, "a completion code is a whole number", "write a whole number");
        }
      }
      break;
    default:
      break;
  }
  if (icon.kind != IconKind::branch && icon.kind != IconKind::exit && icon.kind != IconKind::restart)
    icon.next = fields.connection("next");
  if (has_completions(icon.kind)) icon.error = fields.connection("error");
  read_position(icon, fields);
  icon.note = fields.text("note");
  fields.refuse_the_rest();
  return icon;
}

Operation read_operation(const JsonValue& value, Fields& fields, Diagnostics& diagnostics) {
  Operation operation;
  operation.where = value.where;
  operation.name = fields.needed_text("name", &operation.where);
  operation.description = fields.text("description");
  const JsonValue* icons = fields.find("icons", Kind::array, "a list of icons");
  if (icons == nullptr) fields.missing("icons");
  if (icons != nullptr)
    for (const JsonValue& each : icons->items)
      if (auto icon = read_icon(each, diagnostics)) operation.icons.push_back(std::move(*icon));
  return operation;
}

}  // namespace

std::optional<Document> parse(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  const auto root = parse_json(sources, file, diagnostics);
  if (!root) return std::nullopt;
  Fields fields(*root, diagnostics);
  if (root->kind != Kind::object) {
    fields.report(root->where, "an operation is an object", "write {\"operation-format\": 1, …}");
    return std::nullopt;
  }
  if (const JsonValue* format = fields.find("operation-format"); format == nullptr) {
    fields.missing("operation-format");
  } else if (format->kind != Kind::number || format->number != 1) {
    fields.report(format->where, "this program reads operation-format 1 only", "write 1");
  }
  Document document;
  document.operations.push_back(read_operation(*root, fields, diagnostics));
  if (const JsonValue* others = fields.find("operations", Kind::array, "a list of sub-operations")) {
    for (const JsonValue& each : others->items) {
      Fields sub_fields(each, diagnostics);
      if (each.kind != Kind::object) {
        sub_fields.report(each.where, "a sub-operation is an object", "write {\"name\": …, \"icons\": […]}");
        continue;
      }
      document.operations.push_back(read_operation(each, sub_fields, diagnostics));
      sub_fields.refuse_the_rest();
    }
  }
  fields.refuse_the_rest();
  for (Operation& operation : document.operations) operation.from = sources.name(file);
  return document;
}

}  // namespace pal::operations
