#include "operations/write.hpp"

#include <nlohmann/json.hpp>

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

Json json(const Icon& icon) {
  Json result;
  result["id"] = icon.id;
  result["kind"] = name(icon.kind);
  put(result, "skill", icon.skill);
  for (const Parameter& parameter : icon.parameters) {
    Json& value = result["parameters"][parameter.name];
    if (parameter.count_of.empty()) {
      value = json(parameter.value);
    } else {
      value["count-of"] = parameter.count_of;
    }
  }
  put(result, "operation", icon.operation);
  put(result, "file", icon.file);
  if (icon.kind == IconKind::delay) result["seconds"] = number(icon.seconds);
  put(result, "sensor", icon.sensor);
  for (const double limit : icon.limits) result["limits"].push_back(number(limit));
  if (icon.at_least) result["at-least"] = number(*icon.at_least);
  if (icon.at_most) result["at-most"] = number(*icon.at_most);
  if (icon.timeout) result["timeout"] = number(*icon.timeout);
  for (const Way& way : icon.ways) {
    Json each;
    each["codes"] = way.codes;
    put(each, "to", way.to.icon);
    result["ways"].push_back(std::move(each));
  }
  put(result, "default", icon.otherwise.icon);
  if (icon.code) result["code"] = *icon.code;
  put(result, "next", icon.next.icon);
  put(result, "error", icon.error.icon);
  if (icon.at) result["at"] = {number(icon.at->x), number(icon.at->y)};
  put(result, "note", icon.note);
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

void write_body(const Operation& operation, const std::string& indent, std::string& out) {
  out += indent + "\"name\": " + Json(operation.name).dump() + ",\n";
  if (!operation.description.empty())
    out += indent + "\"description\": " + spaced(Json(operation.description)) + ",\n";
  out += indent + "\"icons\": [\n";
  for (const Icon& icon : operation.icons)
    out += indent + "  " + spaced(json(icon)) + (&icon == &operation.icons.back() ? "\n" : ",\n");
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
