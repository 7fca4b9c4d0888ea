#include "server/json_requests.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace pal::server {

namespace {

const char* why_of(int code) {
  switch (code) {
    case no_json:
      return "no-json";
    case no_request:
      return "no-request";
    case no_method:
      return "no-method";
    case bad_parameters:
      return "bad-parameters";
    case not_admitted:
      return "not-admitted";
    default:
      break;
  }
  static constexpr std::array names{"not-yours", "busy",     "nothing", "wrong",  "ending",
                                    "role",      "held",     "newer",   "absent", "exists",
                                    "cancelled", "too-much", "failed"};
  const auto index = static_cast<std::size_t>(code - first_refusal);
  return code >= first_refusal && index < names.size() ? names[index] : "internal";
}

}  // namespace

Problem problem_of(int code, std::string message, std::string hint) {
  Problem problem{code, std::move(message)};
  problem.data["why"] = why_of(code);
  problem.data["hint"] = std::move(hint);
  return problem;
}

Problem problem_of(const Refusal& refusal) {
  Problem problem = problem_of(first_refusal + static_cast<int>(refusal.why), refusal.message, refusal.hint);
  Json place = Json::object();
  const auto put = [&place](const char* name, const std::string& text) {
    if (!text.empty()) place[name] = text;
  };
  put("file", refusal.place.file);
  put("operation", refusal.place.operation);
  put("icon", refusal.place.icon);
  put("field", refusal.place.field);
  if (refusal.place.line > 0) place["line"] = refusal.place.line;
  if (refusal.place.column > 0) place["column"] = refusal.place.column;
  if (!place.empty()) problem.data["place"] = std::move(place);
  if (refusal.newest) problem.data["newest"] = *refusal.newest;
  if (refusal.limits)
    problem.data["limit"] = {{"low", refusal.limits->first}, {"high", refusal.limits->second}};
  return problem;
}

void fail(int code, std::string message) {
  throw problem_of(code, std::move(message));
}

void fail(Refusal::Why why, std::string message, std::string hint) {
  throw problem_of(Refusal{why, std::move(message), std::move(hint)});
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

Members::Members(Json& request) {
  const auto found = request.find("params");
  if (found == request.end()) return;
  if (!found->is_object()) fail(bad_parameters, "params must be an object, with names");
  json_ = std::make_shared<const Json>(std::move(*found));
}

ParsedRequest read_request(std::string_view text) {
  ParsedRequest result;
  try {
    Json request = parse(text);
    if (request.is_discarded()) fail(no_json, "this is no JSON");
    if (request.is_array()) fail(no_request, "send one request a message: there are no batches");
    if (!request.is_object()) fail(no_request, "a request is an object");
    const auto given = request.find("id");
    if (given != request.end() && (given->is_string() || given->is_number())) result.id = *given;
    const auto method = request.find("method");
    if (request.value("jsonrpc", Json()) != "2.0" || method == request.end() || !method->is_string() ||
        (given != request.end() && result.id.is_null() && !given->is_null()))
      fail(no_request, "a request has \"jsonrpc\": \"2.0\", a method, and an id that is a number or a text");
    result.answered = given != request.end();
    result.method = method->get<std::string>();
    result.members = Members(request);
  } catch (const Problem& problem) {
    result.problem = problem;
  }
  return result;
}

std::string Members::text(const char* name) const {
  const auto found = json_->find(name);
  if (found == json_->end() || !found->is_string())
    fail(bad_parameters, fmt::format("'{}' must be a text", name));
  return found->get<std::string>();
}

std::string Members::text(const char* name, const char* otherwise) const {
  return json_->contains(name) ? text(name) : otherwise;
}

const Json* Members::find(const char* name) const {
  const auto found = json_->find(name);
  return found == json_->end() ? nullptr : &*found;
}

std::optional<std::int64_t> Members::may_be_whole(const char* name, std::int64_t low,
                                                  std::int64_t high) const {
  const Json* found = find(name);
  if (found == nullptr) return std::nullopt;
  const bool fits = found->is_number_integer() && found->get<double>() >= static_cast<double>(low) &&
                    found->get<double>() <= static_cast<double>(high);
  if (!fits) fail(bad_parameters, fmt::format("'{}' must be a whole number from {} to {}", name, low, high));
  return found->get<std::int64_t>();
}

std::int64_t Members::whole(const char* name, std::int64_t low, std::int64_t high) const {
  const auto number = may_be_whole(name, low, high);
  if (!number)
    fail(bad_parameters, fmt::format("'{}' is missing: a whole number from {} to {}", name, low, high));
  return *number;
}

bool Members::truth(const char* name) const {
  const Json* found = find(name);
  if (found == nullptr) return false;
  if (!found->is_boolean()) fail(bad_parameters, fmt::format("'{}' must be true or false", name));
  return found->get<bool>();
}

std::map<std::string, std::string> Members::files() const {
  std::map<std::string, std::string> result;
  const Json* files = find("files");
  if (files == nullptr) return result;
  if (!files->is_object())
    fail(bad_parameters, "'files' must be an object: the text of each file by its name");
  for (const auto& [name, text] : files->items()) {
    if (!text.is_string()) fail(bad_parameters, fmt::format("the text of '{}' must be a text", name));
    result[name] = text.get<std::string>();
  }
  return result;
}

std::string Members::short_text(const char* name, std::size_t most) const {
  std::string result = text(name, "");
  if (result.size() > most) fail(bad_parameters, fmt::format("'{}' has at most {} bytes", name, most));
  return result;
}

operations::Value value_of(const std::string& name, const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  fail(bad_parameters, fmt::format("'{}' must be a number, true, false or a text", name));
}

RunSkill run_skill(const Members& members) {
  RunSkill command{members.text("skill"), {}, members.truth("goes_on")};
  const Json* parameters = members.find("parameters");
  if (parameters == nullptr) return command;
  if (!parameters->is_object()) fail(bad_parameters, "'parameters' must be an object");
  for (const auto& [name, value] : parameters->items())
    command.parameters.push_back({name, value_of(name, value), {}, {}});
  return command;
}

SetParameter set_parameter(const Members& members) {
  const Json* value = members.find("value");
  if (value == nullptr) fail(bad_parameters, "'value' is missing");
  return {members.text("icon"), members.text("parameter"), value_of("value", *value)};
}

namespace {

std::optional<double> limit_of(const Json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) return std::nullopt;
  if (!found->is_number()) fail(bad_parameters, fmt::format("'{}' must be a number", name));
  return found->get<double>();
}

operations::BreakCondition condition_of(const Json& json) {
  if (!json.is_object()) fail(bad_parameters, "'condition' must be an object");
  operations::BreakCondition result;
  const auto text = [&json](const char* name) {
    const auto found = json.find(name);
    if (found == json.end()) return std::string();
    if (!found->is_string()) fail(bad_parameters, fmt::format("'{}' must be a text", name));
    return found->get<std::string>();
  };
  using Kind = operations::Source::Kind;
  const int given = static_cast<int>(json.contains("count-of")) +
                    static_cast<int>(json.contains("argument")) +
                    static_cast<int>(json.contains("output-of"));
  if (given != 1) fail(bad_parameters, "a condition has one of count-of, argument, and output-of with name");
  if (json.contains("count-of")) {
    result.source = {Kind::count, text("count-of"), {}};
  } else if (json.contains("argument")) {
    result.source = {Kind::argument, {}, text("argument")};
  } else {
    result.source = {Kind::output, text("output-of"), text("name")};
  }
  result.at_least = limit_of(json, "at-least");
  result.at_most = limit_of(json, "at-most");
  if (!result.at_least && !result.at_most)
    fail(bad_parameters, "a condition has at-least or at-most, or both");
  return result;
}

}  // namespace

SetBreakpoint set_breakpoint(const Members& members) {
  constexpr std::int64_t most = 1'000'000;
  operations::Breakpoint result{members.text("icon"), {}};
  if (const auto code = members.may_be_whole("code", -most, most)) result.code = static_cast<int>(*code);
  if (const Json* condition = members.find("condition")) result.condition = condition_of(*condition);
  result.every = static_cast<std::size_t>(members.may_be_whole("every", 1, most).value_or(1));
  result.enabled = members.find("enabled") == nullptr || members.truth("enabled");
  result.number = static_cast<std::size_t>(members.may_be_whole("breakpoint", 1, most).value_or(0));
  return {result};
}

AnswerQuestion answer_question(const Members& members) {
  const Json* answer = members.find("answer");
  if (answer == nullptr) fail(bad_parameters, "'answer' is missing: its place from 0, or its text");
  if (answer->is_string()) return {members.text("icon"), answer->get<std::string>()};
  return {members.text("icon"), static_cast<std::size_t>(members.whole("answer", 0, 1000))};
}

}  // namespace pal::server
