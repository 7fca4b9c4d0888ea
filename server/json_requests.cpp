#include "server/json_requests.hpp"

#include <fmt/format.h>

#include <utility>

namespace pal::server {

void fail(int code, std::string message) {
  throw Problem{code, std::move(message)};
}

Json parse(std::string_view text) {
  constexpr int deepest = 16;
  bool too_deep = false;
  const auto look = [&](int depth, Json::parse_event_t, Json&) {
    too_deep = too_deep || depth > deepest;
    return depth <= deepest;
  };
  Json json = Json::parse(text, look, false);
  if (too_deep) fail(no_request, fmt::format("a request is at most {} deep", deepest));
  return json;
}

Members::Members(const Json& request) {
  const auto found = request.find("params");
  if (found == request.end()) return;
  if (!found->is_object()) fail(bad_parameters, "params must be an object, with names");
  json_ = *found;
}

std::string Members::text(const char* name) const {
  const auto found = json_.find(name);
  if (found == json_.end() || !found->is_string())
    fail(bad_parameters, fmt::format("'{}' must be a text", name));
  return found->get<std::string>();
}

std::string Members::text(const char* name, const char* otherwise) const {
  return json_.contains(name) ? text(name) : otherwise;
}

const Json* Members::find(const char* name) const {
  const auto found = json_.find(name);
  return found == json_.end() ? nullptr : &*found;
}

operations::Value value_of(const std::string& name, const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  fail(bad_parameters, fmt::format("'{}' must be a number, true, false or a text", name));
}

RunSkill run_skill(const Members& members) {
  RunSkill command{members.text("skill"), {}};
  const Json* parameters = members.find("parameters");
  if (parameters == nullptr) return command;
  if (!parameters->is_object()) fail(bad_parameters, "'parameters' must be an object");
  for (const auto& [name, value] : parameters->items())
    command.parameters.push_back({name, value_of(name, value), {}, {}});
  return command;
}

LoadOperation load_operation(const Members& members) {
  LoadOperation command;
  command.main = members.text("main");
  const Json* files = members.find("files");
  if (files == nullptr || !files->is_object() || files->empty())
    fail(bad_parameters, "'files' must be an object: the text of each file by its name");
  for (const auto& [name, text] : files->items()) {
    if (!text.is_string()) fail(bad_parameters, fmt::format("the text of '{}' must be a text", name));
    command.files[name] = text.get<std::string>();
  }
  return command;
}

SetParameter set_parameter(const Members& members) {
  const Json* value = members.find("value");
  if (value == nullptr) fail(bad_parameters, "'value' is missing");
  return {members.text("icon"), members.text("parameter"), value_of("value", *value)};
}

operations::Breakpoint breakpoint(const Members& members) {
  operations::Breakpoint result{members.text("icon"), {}};
  const Json* code = members.find("code");
  if (code == nullptr) return result;
  if (!code->is_number_integer() || code->get<double>() < -1e6 || code->get<double>() > 1e6)
    fail(bad_parameters, "'code' must be a completion code");
  result.code = code->get<int>();
  return result;
}

}  // namespace pal::server
