#include "language_server/operation_schema.hpp"

#include <algorithm>

#include "language_server/json.hpp"

namespace pal::language_server {

namespace {

const Json& schema() {
  static const Json read = Json::parse(operation_schema_text());
  return read;
}

using Choices = std::vector<const Json*>;

/// The schema itself, or what it refers to, and each of its choices.
void add_choices(const Json& part, Choices& to) {
  if (const auto reference = part.find("$ref"); reference != part.end()) {
    const std::string name = reference->get<std::string>();
    return add_choices(schema().at("$defs").at(name.substr(name.rfind('/') + 1)), to);
  }
  to.push_back(&part);
  for (const char* group : {"oneOf", "anyOf"})
    if (const auto choices = part.find(group); choices != part.end())
      for (const Json& each : *choices) add_choices(each, to);
}

Choices choices_of(const Json& part) {
  Choices result;
  add_choices(part, result);
  return result;
}

/// Where the object says its kind, those that are of another one go.
void keep_kind(Choices& choices, std::string_view text, const JsonFrame& frame) {
  const auto kind = json_member(text, frame.open, "kind");
  if (!kind) return;
  const auto other = [&kind](const Json* each) {
    const auto said = each->find("properties");
    if (said == each->end() || !said->contains("kind")) return false;
    const Json& known = said->at("kind");
    return known.contains("const") && known.at("const") != *kind;
  };
  // A kind that is being typed is none yet.
  if (!std::ranges::all_of(choices, other)) std::erase_if(choices, other);
}

Choices inside(const Choices& around, const JsonFrame& frame) {
  Choices result;
  for (const Json* each : around) {
    if (!frame.object) {
      if (const auto items = each->find("items"); items != each->end()) add_choices(*items, result);
      continue;
    }
    if (const auto known = each->find("properties"); known != each->end() && known->contains(frame.key)) {
      add_choices(known->at(frame.key), result);
    } else if (const auto more = each->find("additionalProperties");
               more != each->end() && more->is_object()) {
      add_choices(*more, result);
    }
  }
  return result;
}

std::string type_of(const Json& part) {
  const auto type = part.find("type");
  if (type == part.end() || !type->is_string()) return "";
  const std::string name = type->get<std::string>();
  if (name == "string") return "a text";
  if (name == "boolean") return "true or false";
  if (name == "array") return "a list";
  if (name == "object") return "an object";
  std::string text = name == "integer" ? "a whole number" : "a number";
  if (part.contains("minimum")) text += " from " + part.at("minimum").dump();
  if (part.contains("maximum")) text += " to " + part.at("maximum").dump();
  return text;
}

SchemaMember member_of(const std::string& name, const Json& part) {
  SchemaMember result;
  result.name = name;
  for (const Json* each : choices_of(part)) {
    if (result.type.empty()) result.type = type_of(*each);
    if (result.words.empty()) result.words = each->value("description", "");
    if (const auto only = each->find("const"); only != each->end()) result.values.push_back(only->dump());
    if (const auto some = each->find("enum"); some != each->end())
      for (const Json& value : *some) result.values.push_back(value.dump());
    if (each->value("type", Json()) == "boolean")
      result.values.insert(result.values.end(), {"true", "false"});
  }
  if (part.contains("description")) result.words = part.at("description").get<std::string>();
  return result;
}

}  // namespace

std::vector<SchemaMember> members_at(std::string_view text, const JsonPlace& place) {
  if (place.frames.empty() || !place.frames.back().object) return {};
  Choices choices = choices_of(schema());
  for (std::size_t i = 0; i < place.frames.size(); ++i) {
    if (place.frames[i].object) keep_kind(choices, text, place.frames[i]);
    if (i + 1 < place.frames.size()) choices = inside(choices, place.frames[i]);
  }
  std::vector<SchemaMember> result;
  for (const Json* each : choices) {
    const auto known = each->find("properties");
    if (known == each->end()) continue;
    for (const auto& [name, part] : known->items()) {
      SchemaMember member = member_of(name, part);
      const auto there = std::ranges::find(result, name, &SchemaMember::name);
      if (there == result.end()) {
        result.push_back(std::move(member));
      } else {
        for (std::string& value : member.values)
          if (std::ranges::find(there->values, value) == there->values.end())
            there->values.push_back(std::move(value));
      }
    }
  }
  return result;
}

}  // namespace pal::language_server
