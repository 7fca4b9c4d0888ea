#include "server/json_events.hpp"

#include <array>

#include "server/json_values.hpp"

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
  void operator()(const ControlsAsked& what) const { put("asked", describe(what)); }
  void operator()(const ClientsChanged& what) const { put("clients", {{"clients", describe(what.clients)}}); }
  void operator()(const HoldChanged& what) const {
    put("hold", {{"hold", describe(what.hold)}, {"by", what.by}});
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
    put("question", {{"question", describe(what.question)}});
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

std::string event_text(const Event& event) {
  Json json;
  json["number"] = event.number;
  json["time_s"] = seconds(event.time);
  json["wall"] = wall_text(event.wall);
  std::visit(EventFields{json}, event.what);
  return dump(json);
}

}  // namespace pal::server
