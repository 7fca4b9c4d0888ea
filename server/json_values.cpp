#include "server/json_values.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <array>

#include "operations/missing_value.hpp"
#include "operations/step_log.hpp"

namespace pal::server {
namespace {

Json describe_state(const StateChanged& state) {
  Json json;
  json["state"] = operations::name(state.state);
  json["token"] = state.token;
  json["last_code"] = state.last_code;
  json["steps"] = state.steps;
  json["reason"] = state.reason;
  return json;
}

Json describe_client(const Present& client) {
  return {{"client", client.client},
          {"name", client.name},
          {"role", name(client.role)},
          {"controls", client.controls},
          {"since", wall_text(client.since)}};
}

Json describe_hold(const std::optional<Hold>& hold) {
  if (!hold) return nullptr;
  return {{"by", hold->by},
          {"client", hold->client},
          {"role", name(hold->role)},
          {"reason", hold->reason},
          {"since", wall_text(hold->since)}};
}

Json describe_question(const OpenQuestion& question) {
  return {{"icon", question.question.icon},
          {"text", question.question.text},
          {"answers", question.question.answers},
          {"since_s", seconds(question.since)},
          {"since", wall_text(question.since_wall)}};
}

Json describe_asking(const ControlsAsked& asking) {
  return {{"client", asking.client}, {"name", asking.name}, {"reason", asking.reason}};
}

Json describe_source(const operations::Source& source) {
  using Kind = operations::Source::Kind;
  if (source.kind == Kind::count) return {{"count-of", source.icon}};
  if (source.kind == Kind::argument) return {{"argument", source.name}};
  return {{"output-of", source.icon}, {"name", source.name}};
}

Json describe_step(const operations::Step& step, bool ended) {
  Json json = Json::parse(operations::log_line(step));
  if (ended) return json;
  for (const char* later : {"reading", "readings", "answer", "figures", "kind", "code", "reason", "end_s"})
    json.erase(later);
  return json;
}

const char* type_name(pan::ScalarType type) {
  switch (type) {
    case pan::ScalarType::integer:
      return "integer";
    case pan::ScalarType::boolean:
      return "boolean";
    case pan::ScalarType::text:
      return "text";
    default:
      return "real";
  }
}

}  // namespace

double seconds(Duration time) {
  return static_cast<double>(time.count()) / 1e9;
}

std::string wall_text(WallTime time) {
  const auto whole = std::chrono::time_point_cast<std::chrono::milliseconds>(time);
  const auto second = std::chrono::floor<std::chrono::seconds>(whole);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(std::chrono::system_clock::to_time_t(second)),
                     (whole - second).count());
}

std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json describe(const operations::Value& value) {
  return std::visit([](const auto& each) { return Json(each); }, value);
}

Json value_or_null(const std::optional<operations::Value>& value) {
  return value ? describe(*value) : Json();
}

Json describe(const std::vector<operations::Parameter>& parameters) {
  Json json = Json::object();
  for (const operations::Parameter& each : parameters)
    json[each.name] = each.source.written() ? describe(each.value) : Json(operations::to_text(each));
  return json;
}

namespace {

/// The event's name, and what it says.
struct EventFields {
  Json& json;
  void put(const char* event, const Json& fields) const {
    json["event"] = event;
    json.update(fields);
  }
  void operator()(const ControlsChanged& what) const {
    put("controls", {{"holder", what.holder},
                     {"client", what.client ? Json(*what.client) : Json()},
                     {"reason", what.reason}});
  }
  void operator()(const ControlsAsked& what) const { put("asked", describe_asking(what)); }
  void operator()(const ClientsChanged& what) const { put("clients", {{"clients", describe(what.clients)}}); }
  void operator()(const HoldChanged& what) const {
    put("hold", {{"hold", describe_hold(what.hold)}, {"by", what.by}});
  }
  void operator()(const OperationLoaded& what) const {
    put("loaded", {{"operation", what.name}, {"by", what.by}});
  }
  void operator()(const StateChanged& what) const { put("state", describe_state(what)); }
  void operator()(const HaltAsked& what) const {
    put("pausing", {{"pausing", what.pausing}, {"stopping", what.stopping}, {"by", what.by}});
  }
  void operator()(const IconReached& what) const { put("icon", {{"icon", what.icon}}); }
  void operator()(const StepBegins& what) const { put("begins", describe_step(what.step, false)); }
  void operator()(const StepEnds& what) const { put("ends", describe_step(what.step, true)); }
  void operator()(const ParameterSet& what) const {
    put("set", {{"icon", what.icon},
                {"parameter", what.parameter},
                {"value", describe(what.value)},
                {"before", value_or_null(what.before)},
                {"by", what.by}});
  }
  void operator()(const BreakpointsChanged& what) const {
    put("breakpoints", {{"breakpoints", describe(what.breakpoints)}, {"by", what.by}});
  }
  void operator()(const QuestionAsked& what) const {
    put("question", {{"question", describe_question(what.question)}});
  }
  void operator()(const QuestionClosed& what) const {
    put("answered",
        {{"icon", what.icon}, {"answer", what.answer ? Json(*what.answer) : Json()}, {"by", what.by}});
  }
  void operator()(const StoreChanged& what) const {
    static constexpr std::array changes{"saved", "renamed", "deleted"};
    put("stored", {{"name", what.name},
                   {"change", changes[static_cast<std::size_t>(what.change)]},
                   {"version", what.version}});
    if (!what.to.empty()) json["to"] = what.to;
    json["by"] = what.by;
  }
  void operator()(const LocationChanged& what) const {
    static constexpr std::array changes{"taught", "renamed", "deleted"};
    put("location", {{"location", what.location},
                     {"change", changes[static_cast<std::size_t>(what.change)]},
                     {"version", what.version}});
    if (!what.to.empty()) json["to"] = what.to;
    json["by"] = what.by;
  }
  void operator()(const ServerEnds& what) const { put("ending", {{"reason", what.reason}}); }
};

}  // namespace

Json describe(const Event& event) {
  Json json;
  json["number"] = event.number;
  json["time_s"] = seconds(event.time);
  json["wall"] = wall_text(event.wall);
  std::visit(EventFields{json}, event.what);
  return json;
}

Json describe(const Status& status) {
  Json json;
  json["cell"] = status.cell;
  json["activity"] = name(status.activity);
  json["operation"] = status.operation;
  json["state"] = operations::name(status.state);
  json["token"] = status.token;
  json["last_code"] = status.last_code;
  json["steps"] = status.steps;
  json["reason"] = status.reason;
  json["controls"] = status.holder;
  json["yours"] = status.yours;
  json["last_event"] = status.last_event;
  json["time_s"] = seconds(status.time);
  json["epoch"] = status.epoch;
  json["wall"] = wall_text(status.wall);
  json["pausing"] = status.pausing;
  json["stopping"] = status.stopping;
  json["running"] = nullptr;
  if (status.running) {
    json["running"] = describe_step(status.running->step, false);
    json["running"]["begin_wall"] = wall_text(status.running->begin);
    json["running"]["alone"] = status.running->alone;
  }
  json["hold"] = describe_hold(status.hold);
  json["question"] = status.question ? describe_question(*status.question) : Json();
  return json;
}

Json describe(const std::vector<Present>& clients) {
  Json list = Json::array();
  for (const Present& each : clients) list.push_back(describe_client(each));
  return list;
}

Json describe(const operations::Breakpoint& breakpoint) {
  Json json{{"breakpoint", breakpoint.number}, {"icon", breakpoint.icon}};
  if (breakpoint.code) json["code"] = *breakpoint.code;
  if (breakpoint.condition) {
    json["condition"] = describe_source(breakpoint.condition->source);
    if (breakpoint.condition->at_least) json["condition"]["at-least"] = *breakpoint.condition->at_least;
    if (breakpoint.condition->at_most) json["condition"]["at-most"] = *breakpoint.condition->at_most;
  }
  if (breakpoint.every > 1) json["every"] = breakpoint.every;
  json["enabled"] = breakpoint.enabled;
  json["hits"] = breakpoint.hits;
  return json;
}

Json describe(const std::vector<operations::Breakpoint>& breakpoints) {
  Json list = Json::array();
  for (const operations::Breakpoint& each : breakpoints) list.push_back(describe(each));
  return list;
}

Json describe(const Snapshot& snapshot) {
  Json json = describe(snapshot.status);
  json["client"] = snapshot.client;
  json["role"] = name(snapshot.role);
  json["loaded"] = nullptr;
  if (snapshot.loaded) {
    json["loaded"] = {
        {"main", snapshot.loaded->main}, {"files", snapshot.loaded->files}, {"stored", nullptr}};
    if (snapshot.loaded->stored)
      json["loaded"]["stored"] = {{"name", snapshot.loaded->stored->name},
                                  {"version", snapshot.loaded->stored->version}};
  }
  json["changed"] = Json::array();
  for (const auto& [at, change] : snapshot.changed)
    json["changed"].push_back({{"icon", at.first},
                               {"parameter", at.second},
                               {"value", describe(change.value)},
                               {"before", value_or_null(change.before)},
                               {"by", change.by}});
  json["breakpoints"] = describe(snapshot.breakpoints);
  json["icons"] = Json::array();
  static constexpr std::array kinds{"normal", "contingency", "error", "stopped"};
  for (const auto& [icon, state] : snapshot.icons) {
    Json each{{"icon", icon}, {"visits", state.visits}, {"ends", state.ends}};
    if (state.code) each["code"] = *state.code;
    each["kind"] = kinds[static_cast<std::size_t>(state.kind)];
    each["last_s"] = seconds(state.last);
    json["icons"].push_back(std::move(each));
  }
  json["here"] = nullptr;
  if (snapshot.here)
    json["here"] = {{"icon", snapshot.here->icon},
                    {"since_s", seconds(snapshot.here->since)},
                    {"since", wall_text(snapshot.here->since_wall)}};
  json["clients"] = describe(snapshot.clients);
  json["asking"] = Json::array();
  for (const ControlsAsked& each : snapshot.asking) json["asking"].push_back(describe_asking(each));
  return json;
}

Json describe(const Outlook& outlook) {
  Json json{{"state", operations::name(outlook.state)}, {"token", outlook.token}, {"reason", outlook.reason}};
  json["choices"] = Json::array();
  static constexpr std::array places{"here", "before", "start", "other"};
  for (const Choice& choice : outlook.choices)
    json["choices"].push_back({{"icon", choice.icon},
                               {"place", places[static_cast<std::size_t>(choice.where)]},
                               {"method", choice.method},
                               {"repeats", choice.repeats},
                               {"skill", choice.skill},
                               {"parameters", describe(choice.parameters)},
                               {"preconditions", choice.preconditions},
                               {"forgets", choice.forgets},
                               {"text", choice.text}});
  return json;
}

Json describe(const IconValues& values) {
  Json json{{"icon", values.icon}, {"skill", values.skill}, {"parameters", Json::array()}};
  for (const IconValue& value : values.values) {
    Json each{{"name", value.name}, {"value", value_or_null(value.value)}, {"set", value.set}};
    if (!value.source.written()) each["source"] = describe_source(value.source);
    if (value.limits) each["operator"] = {{"low", value.limits->first}, {"high", value.limits->second}};
    json["parameters"].push_back(std::move(each));
  }
  return json;
}

namespace {

Json describe_parameter(const pan::Parameter& parameter) {
  Json one;
  one["name"] = parameter.name;
  one["type"] = type_name(parameter.type);
  one["unit"] = parameter.unit;
  one["default"] = describe(operations::default_of(parameter));
  if (parameter.low < parameter.high) {
    one["low"] = parameter.low;
    one["high"] = parameter.high;
  }
  one["description"] = parameter.description;
  one["location"] = operations::is_location(parameter);
  return one;
}

Json describe_completion(const pan::Completion& completion, const std::string& skill, const Facts& facts) {
  static constexpr std::array kinds{"normal", "contingency", "error"};
  Json one{{"code", completion.code},
           {"kind", kinds[static_cast<std::size_t>(completion.kind)]},
           {"description", completion.description}};
  if (completion.contingency > 0) one["contingency"] = completion.contingency;
  const auto time = facts.times.find({skill, completion.code});
  one["longest_s"] = time == facts.times.end() ? Json() : Json(seconds(time->second));
  return one;
}

}  // namespace

Json describe(const KnownRequirement& requirement) {
  static constexpr std::array verdicts{"holds", "fails", "undecided", "not-proved", "proving"};
  const auto number = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  return {{"name", requirement.name},
          {"text", requirement.text},
          {"verdict", verdicts[static_cast<std::size_t>(requirement.verdict)]},
          {"bound", number(requirement.bound)},
          {"limit", number(requirement.limit)},
          {"unit", requirement.unit}};
}

Json describe(const operations::Skills& skills, const Facts& facts,
              const std::map<std::string, std::string>& unable) {
  Json list = Json::array();
  for (const auto& [name, known] : skills) {
    const auto fact = facts.skills.find(name);
    const pan::Template& skill = fact == facts.skills.end() ? known : fact->second.skill;
    Json each;
    each["skill"] = name;
    each["description"] = skill.descriptions.empty() ? "" : skill.descriptions.front();
    each["descriptions"] = skill.descriptions;
    each["preconditions"] = skill.preconditions;
    each["postconditions"] = skill.postconditions;
    each["model_data"] = skill.model_data;
    each["parameters"] = Json::array();
    for (const pan::Parameter& parameter : skill.parameters)
      each["parameters"].push_back(describe_parameter(parameter));
    each["completions"] = Json::array();
    for (const pan::Completion& completion : skill.completions)
      each["completions"].push_back(describe_completion(completion, name, facts));
    each["contingencies"] = Json::array();
    for (const pan::Contingency& contingency : skill.contingencies)
      each["contingencies"].push_back(
          {{"number", contingency.number}, {"description", contingency.description}});
    each["requirements"] = Json::array();
    each["tool"] = "";
    const auto why = unable.find(name);
    each["able"] = why == unable.end();
    each["unable"] = why == unable.end() ? "" : why->second;
    each["environment"] = "";
    each["pictures"] = Json::array();
    if (fact != facts.skills.end()) {
      for (const KnownRequirement& requirement : fact->second.requirements)
        each["requirements"].push_back(describe(requirement));
      each["tool"] = fact->second.tool;
      each["environment"] = fact->second.environment;
      for (const SkillFacts::Picture& picture : fact->second.pictures)
        each["pictures"].push_back({{"title", picture.title}, {"path", picture.path}});
    }
    list.push_back(std::move(each));
  }
  return list;
}

Json describe(const operations::Sensors& sensors) {
  Json list = Json::array();
  for (const auto& [name, sensor] : sensors)
    list.push_back({{"sensor", name}, {"unit", sensor.unit}, {"description", sensor.description}});
  return list;
}

Json describe(const StoredEntry& entry) {
  return {{"name", entry.name},
          {"version", entry.version},
          {"operation", entry.operation},
          {"saved", wall_text(entry.saved)},
          {"by", entry.by},
          {"note", entry.note},
          {"size", entry.size}};
}

Json describe(const Done& done, bool skill) {
  Json json = Json::object();
  if (!skill) return json;
  static constexpr std::array kinds{"normal", "contingency", "error", "stopped"};
  json["kind"] = kinds[static_cast<std::size_t>(done.result.kind)];
  json["code"] = done.result.code;
  json["reason"] = done.result.reason;
  if (!done.result.figures.empty())
    for (const operations::Figure& figure : done.result.figures) json["figures"][figure.name] = figure.value;
  json["begin_s"] = seconds(done.begin);
  json["end_s"] = seconds(done.end);
  return json;
}

}  // namespace pal::server
