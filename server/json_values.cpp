#include "server/json_values.hpp"

#include <array>

#include "operations/step_log.hpp"

namespace pal::server {
namespace {

Json describe(const StateChanged& state) {
  Json json;
  json["state"] = operations::name(state.state);
  json["token"] = state.token;
  json["last_code"] = state.last_code;
  json["steps"] = state.steps;
  json["reason"] = state.reason;
  return json;
}

Json describe(const operations::Step& step, bool ended) {
  Json json = Json::parse(operations::log_line(step));
  if (ended) return json;
  for (const char* later : {"reading", "kind", "code", "reason", "end_s"}) json.erase(later);
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

std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json describe(const Event& event) {
  Json json;
  json["number"] = event.number;
  json["time_s"] = seconds(event.time);
  const auto add = [&](const char* name, const Json& fields) {
    json["event"] = name;
    json.update(fields);
  };
  struct Visitor {
    decltype(add)& put;
    void operator()(const ControlsChanged& what) const { put("controls", {{"holder", what.holder}}); }
    void operator()(const OperationLoaded& what) const { put("loaded", {{"operation", what.name}}); }
    void operator()(const StateChanged& what) const { put("state", describe(what)); }
    void operator()(const IconReached& what) const { put("icon", {{"icon", what.icon}}); }
    void operator()(const StepBegins& what) const { put("begins", describe(what.step, false)); }
    void operator()(const StepEnds& what) const { put("ends", describe(what.step, true)); }
  };
  std::visit(Visitor{add}, event.what);
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
  return json;
}

Json describe(const operations::Skills& skills) {
  Json list = Json::array();
  for (const auto& [name, skill] : skills) {
    Json each;
    each["skill"] = name;
    each["description"] = skill.descriptions.empty() ? "" : skill.descriptions.front();
    each["parameters"] = Json::array();
    for (const pan::Parameter& parameter : skill.parameters) {
      Json one;
      one["name"] = parameter.name;
      one["type"] = type_name(parameter.type);
      one["unit"] = parameter.unit;
      if (parameter.type == pan::ScalarType::text) {
        one["default"] = parameter.default_text;
      } else {
        one["default"] = parameter.default_value;
      }
      if (parameter.low < parameter.high) {
        one["low"] = parameter.low;
        one["high"] = parameter.high;
      }
      one["description"] = parameter.description;
      each["parameters"].push_back(std::move(one));
    }
    each["completions"] = Json::array();
    static constexpr std::array kinds{"normal", "contingency", "error"};
    for (const pan::Completion& completion : skill.completions)
      each["completions"].push_back({{"code", completion.code},
                                     {"kind", kinds[static_cast<std::size_t>(completion.kind)]},
                                     {"description", completion.description}});
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

Json describe(const Done& done, bool skill) {
  Json json = Json::object();
  if (!skill) return json;
  static constexpr std::array kinds{"normal", "contingency", "error", "stopped"};
  json["kind"] = kinds[static_cast<std::size_t>(done.result.kind)];
  json["code"] = done.result.code;
  json["reason"] = done.result.reason;
  json["begin_s"] = seconds(done.begin);
  json["end_s"] = seconds(done.end);
  return json;
}

}  // namespace pal::server
