// The state of the cell and of its operation, as the JSON protocol tells it.
#include <array>

#include "server/json_values.hpp"

namespace pal::server {
namespace {

Json describe_client(const Present& client) {
  return {{"client", client.client},
          {"name", client.name},
          {"role", name(client.role)},
          {"controls", client.controls},
          {"since", wall_text(client.since)}};
}

}  // namespace

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
  json["hold"] = describe(status.hold);
  json["question"] = status.question ? describe(*status.question) : Json();
  json["run"] = status.run;
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
    json["condition"] = describe(breakpoint.condition->source);
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
    each["reason"] = state.reason;
    if (state.took) each["took_s"] = seconds(*state.took);
    json["icons"].push_back(std::move(each));
  }
  json["here"] = nullptr;
  if (snapshot.here)
    json["here"] = {{"icon", snapshot.here->icon},
                    {"since_s", seconds(snapshot.here->since)},
                    {"since", wall_text(snapshot.here->since_wall)}};
  json["clients"] = describe(snapshot.clients);
  json["asking"] = Json::array();
  for (const ControlsAsked& each : snapshot.asking) json["asking"].push_back(describe(each));
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
    if (!value.source.written()) each["source"] = describe(value.source);
    if (value.limits) each["operator"] = {{"low", value.limits->first}, {"high", value.limits->second}};
    json["parameters"].push_back(std::move(each));
  }
  return json;
}

}  // namespace pal::server
