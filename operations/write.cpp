#include "operations/write.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

namespace pal::operations {
namespace {

using Json = nlohmann::ordered_json;

/// A whole number is written as one.
Json number(double value) {
  const auto whole = static_cast<std::int64_t>(value);
  if (static_cast<double>(whole) == value) return whole;
  return value;
}

Json json(const Value& value) {
  if (const auto* real = std::get_if<double>(&value)) return number(*real);
  if (const auto* truth = std::get_if<bool>(&value)) return *truth;
  return std::get<std::string>(value);
}

void put(Json& json, const char* name, const std::string& text) {
  if (!text.empty()) json[name] = text;
}

Json json(const Source& source) {
  if (source.kind == Source::Kind::count) return {{"count-of", source.icon}};
  if (source.kind == Source::Kind::argument) return {{"argument", source.name}};
  return {{"output-of", source.icon}, {"name", source.name}};
}

Json json(const Amount& amount) {
  return amount.source.written() ? number(amount.number) : json(amount.source);
}

void put(Json& out, const char* name, const std::optional<Amount>& amount) {
  if (amount) out[name] = json(*amount);
}

void put(Json& out, const Condition& condition) {
  put(out, "sensor", condition.sensor);
  if (!condition.value.source.written()) out["value"] = json(condition.value.source);
  put(out, "at-least", condition.at_least);
  put(out, "at-most", condition.at_most);
  if (condition.hysteresis != 0) out["hysteresis"] = number(condition.hysteresis);
  if (condition.mean_of != 1) out["mean-of"] = condition.mean_of;
}

void put_what_is_read(Json& out, const Icon& icon) {
  for (const Condition& condition : icon.conditions) {
    if (icon.combination == Combination::one) {
      put(out, condition);
    } else {
      put(out[icon.combination == Combination::all ? "all" : "any"].emplace_back(), condition);
    }
  }
  for (const Amount& limit : icon.limits) out["limits"].push_back(json(limit));
}

Json json(const pan::Parameter& argument) {
  Json result;
  if (argument.type == pan::ScalarType::text) {
    result["default"] = argument.default_text;
  } else if (argument.type == pan::ScalarType::boolean) {
    result["default"] = argument.default_value != 0;
  } else {
    result["default"] = number(argument.default_value);
    result["from"] = number(argument.low);
    result["to"] = number(argument.high);
    if (argument.type == pan::ScalarType::integer) result["whole"] = true;
    put(result, "unit", argument.unit);
  }
  put(result, "note", argument.description);
  return result;
}

void put_answers(Json& out, const Icon& icon) {
  for (const Way& answer : icon.ways) {
    Json& each = out["answers"].emplace_back();
    each["text"] = answer.text;
    put(each, "to", answer.to.icon);
  }
}

void put_codes(Json& out, const Icon& icon) {
  for (const pan::Parameter& each : icon.planned) out["arguments"][each.name] = json(each);
  for (const Way& code : icon.ways) {
    Json& each = out["codes"].emplace_back();
    each["code"] = code.codes.front();
    each["text"] = code.text;
  }
}

Json json(const KeptBreakpoint& breakpoint) {
  Json result = Json::object();
  if (breakpoint.code) result["code"] = *breakpoint.code;
  if (breakpoint.condition) {
    result["value"] = json(breakpoint.condition->source);
    if (breakpoint.condition->at_least) result["at-least"] = number(*breakpoint.condition->at_least);
    if (breakpoint.condition->at_most) result["at-most"] = number(*breakpoint.condition->at_most);
  }
  if (breakpoint.every != 1) result["every"] = breakpoint.every;
  if (!breakpoint.enabled) result["enabled"] = false;
  return result;
}

/// By name: two editors that set them in different order write the same.
std::vector<const Parameter*> in_order(const std::vector<Parameter>& parameters) {
  std::vector<const Parameter*> ordered;
  for (const Parameter& parameter : parameters) ordered.push_back(&parameter);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const Parameter* one, const Parameter* other) { return one->name < other->name; });
  return ordered;
}

/// All but where it stands in the drawing, and what it is called.
Json content(const Icon& icon) {
  Json result;
  result["kind"] = name(icon.kind);
  put(result, "skill", icon.skill);
  put(result, "operation", icon.operation);
  put(result, "file", icon.file);
  for (const Parameter* parameter : in_order(icon.parameters))
    result["parameters"][parameter->name] =
        parameter->source.written() ? json(parameter->value) : json(parameter->source);
  for (const OperatorMaySet& each : icon.operator_may_set) {
    Json& limits = result["operator"][each.parameter] = Json::object();
    if (each.from) limits["from"] = number(*each.from);
    if (each.to) limits["to"] = number(*each.to);
  }
  put(result, "repeat", icon.repeat);
  put(result, "time-limit", icon.time_limit);
  if (icon.retries != 0) result["retries"] = icon.retries;
  if (!icon.retry_on.empty()) result["retry-on"] = icon.retry_on;
  put(result, "seconds", icon.seconds);
  put(result, "sensor", icon.sensor);
  put_what_is_read(result, icon);
  put(result, "text", icon.text);
  if (icon.kind == IconKind::question) put_answers(result, icon);
  if (icon.kind == IconKind::planned) put_codes(result, icon);
  put(result, "timeout", icon.timeout);
  for (const Way& way : icon.ways) {
    if (icon.kind != IconKind::branch) break;
    Json each;
    each["codes"] = way.codes;
    put(each, "to", way.to.icon);
    result["ways"].push_back(std::move(each));
  }
  put(result, "default", icon.otherwise.icon);
  put(result, "code", icon.code);
  put(result, "next", icon.next.icon);
  put(result, "error", icon.error.icon);
  put(result, "note", icon.note);
  return result;
}

Json json(const OnStop& on_stop) {
  if (on_stop.file.empty()) return on_stop.operation;
  Json result;
  result["file"] = on_stop.file;
  put(result, "operation", on_stop.operation);
  return result;
}

/// With a blank after each comma and colon that is no part of a text.
std::string spaced(const Json& json) {
  std::string result;
  bool inside = false;
  const std::string dense = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t i = 0; i < dense.size(); ++i) {
    result += dense[i];
    if (inside && dense[i] == '\\') {
      result += dense[++i];
    } else if (dense[i] == '"') {
      inside = !inside;
    } else if (!inside && (dense[i] == ',' || dense[i] == ':')) {
      result += ' ';
    }
  }
  return result;
}

/// Where an icon stands has a line of its own, and its name is between that and its content. So a merge joins
/// the work of one person who moves it and of another one who sets it. A breakpoint is no content, either.
void write_icon(const Icon& icon, const std::string& indent, std::string& out) {
  const std::string inner = indent + "  ";
  out += indent + "{\n";
  if (icon.at) out += inner + "\"at\": " + spaced(Json{number(icon.at->x), number(icon.at->y)}) + ",\n";
  out += inner + "\"id\": " + spaced(Json(icon.id)) + ",\n";
  if (icon.breakpoint) out += inner + "\"break\": " + spaced(json(*icon.breakpoint)) + ",\n";
  const std::string all = spaced(content(icon));
  out += inner + all.substr(1, all.size() - 2) + "\n";
  out += indent + "}";
}

/// An argument a line.
void write_arguments(const Operation& operation, const std::string& indent, std::string& out) {
  if (operation.arguments.empty()) return;
  out += indent + "\"arguments\": {\n";
  for (const pan::Parameter& each : operation.arguments)
    out += indent + "  " + spaced(Json(each.name)) + ": " + spaced(json(each)) +
           (&each == &operation.arguments.back() ? "\n" : ",\n");
  out += indent + "},\n";
}

void write_body(const Operation& operation, const std::string& indent, std::string& out) {
  out += indent + "\"name\": " + Json(operation.name).dump() + ",\n";
  if (!operation.description.empty())
    out += indent + "\"description\": " + spaced(Json(operation.description)) + ",\n";
  write_arguments(operation, indent, out);
  if (operation.on_stop.given()) out += indent + "\"on-stop\": " + spaced(json(operation.on_stop)) + ",\n";
  out += indent + "\"icons\": [\n";
  for (const Icon& icon : operation.icons) {
    write_icon(icon, indent + "  ", out);
    out += &icon == &operation.icons.back() ? "\n" : ",\n";
  }
  out += indent + "]";
}

}  // namespace

std::string write(const Document& document) {
  std::string out = "{\n  \"operation-format\": 1,\n";
  if (document.operations.empty()) return out + "  \"name\": \"\",\n  \"icons\": []\n}\n";
  write_body(document.operations.front(), "  ", out);
  if (document.operations.size() > 1) {
    out += ",\n  \"operations\": [\n";
    for (std::size_t i = 1; i < document.operations.size(); ++i) {
      out += "    {\n";
      write_body(document.operations[i], "      ", out);
      out += i + 1 < document.operations.size() ? "\n    },\n" : "\n    }\n";
    }
    out += "  ]";
  }
  return out + "\n}\n";
}

}  // namespace pal::operations
