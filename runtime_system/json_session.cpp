#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "operations/step_log.hpp"
#include "runtime_system/rights.hpp"
#include "runtime_system/session.hpp"

namespace pal::runtime_system {
namespace {

using Json = nlohmann::ordered_json;

// JSON-RPC's own codes, then ours.
constexpr int no_json = -32700, no_request = -32600, no_method = -32601, bad_parameters = -32602;
constexpr int not_admitted = 1, first_refusal = 2;

struct Problem {
  int code = 0;
  std::string message;
};

[[noreturn]] void fail(int code, std::string message) {
  throw Problem{code, std::move(message)};
}

double seconds(Duration time) {
  return static_cast<double>(time.count()) / 1e9;
}

std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

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

/// Nothing deep gets as far as to code that calls itself.
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

/// The members of "params": an object, or nothing.
class Members {
 public:
  explicit Members(const Json& request) {
    const auto found = request.find("params");
    if (found == request.end()) return;
    if (!found->is_object()) fail(bad_parameters, "params must be an object, with names");
    json_ = *found;
  }
  std::string text(const char* name) const {
    const auto found = json_.find(name);
    if (found == json_.end() || !found->is_string())
      fail(bad_parameters, fmt::format("'{}' must be a text", name));
    return found->get<std::string>();
  }
  std::string text(const char* name, const char* otherwise) const {
    return json_.contains(name) ? text(name) : otherwise;
  }
  const Json* find(const char* name) const {
    const auto found = json_.find(name);
    return found == json_.end() ? nullptr : &*found;
  }

 private:
  Json json_ = Json::object();
};

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

operations::Breakpoint breakpoint(const Members& members) {
  operations::Breakpoint result{members.text("icon"), {}};
  const Json* code = members.find("code");
  if (code == nullptr) return result;
  if (!code->is_number_integer() || code->get<double>() < -1e6 || code->get<double>() > 1e6)
    fail(bad_parameters, "'code' must be a completion code");
  result.code = code->get<int>();
  return result;
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

class JsonSession final : public Session {
 public:
  JsonSession(Lobby& lobby, Mouth mouth)
      : lobby_(lobby), mouth_(std::move(mouth)), alive_(std::make_shared<bool>(true)) {}
  ~JsonSession() override {
    *alive_ = false;
    if (client_) lobby_.desk.leave(*client_);
  }

  void take(std::string_view text) override {
    Json id;  // null: it is not known
    bool answered = true;
    try {
      const Json request = parse(text);
      if (request.is_discarded()) fail(no_json, "this is no JSON");
      if (request.is_array()) fail(no_request, "send one request a message: there are no batches");
      if (!request.is_object()) fail(no_request, "a request is an object");
      const auto given = request.find("id");
      if (given != request.end() && (given->is_string() || given->is_number())) id = *given;
      const auto method = request.find("method");
      if (request.value("jsonrpc", Json()) != "2.0" || method == request.end() || !method->is_string() ||
          (given != request.end() && id.is_null() && !given->is_null()))
        fail(no_request,
             "a request has \"jsonrpc\": \"2.0\", a method, and an id that is a number or a text");
      answered = given != request.end();
      obey(method->get<std::string>(), Members(request), id, answered);
    } catch (const Problem& problem) {
      if (answered) refuse(id, problem.code, problem.message);
    }
  }

  void happened(const Event& event) override {
    if (watching_ && event.number > said_) notify(event);
  }
  void show(const std::shared_ptr<const Telemetry>& telemetry) override {
    if (!looks() || telemetry->time < due_) return;
    due_ = telemetry->time + period_;
    mouth_.show([telemetry](std::uint64_t dropped) {
      Json params;
      params["time_s"] = seconds(telemetry->time);
      params["force"] = telemetry->force;
      params["pose"] = telemetry->pose;
      params["joints"] = telemetry->joints;
      params["dropped"] = dropped;
      return dump({{"jsonrpc", "2.0"}, {"method", "telemetry"}, {"params", std::move(params)}});
    });
  }
  void show(Duration time, const std::shared_ptr<const Profile>& profile) override {
    if (!looks()) return;
    mouth_.show([time, profile](std::uint64_t dropped) {
      Json params;
      params["time_s"] = seconds(time);
      params["y_mm"] = profile->y;
      params["z_mm"] = profile->z;
      params["dropped"] = dropped;
      return dump({{"jsonrpc", "2.0"}, {"method", "profile"}, {"params", std::move(params)}});
    });
  }
  bool admitted() const override { return client_.has_value(); }
  bool looks() const override { return period_ > Duration::zero(); }

 private:
  void obey(const std::string& method, const Members& members, const Json& id, bool answered) {
    if (method == "hello") return hello(members, id, answered);
    if (!client_) {
      if (answered) refuse(id, not_admitted, "say hello with the token first");
      return mouth_.hang_up();
    }
    if (method == "state") return result(id, answered, describe(lobby_.desk.status(*client_)));
    if (method == "skills") return result(id, answered, describe(lobby_.desk.skills()));
    if (method == "sensors") return result(id, answered, describe(lobby_.desk.sensors()));
    if (method == "watch") return watch(members, id, answered);
    if (method == "controls.take") return ask(TakeControls{}, id, answered);
    if (method == "controls.release") return ask(ReleaseControls{}, id, answered);
    if (method == "skill.run") return ask(run_skill(members), id, answered, true);
    if (method == "stop") return ask(Stop{}, id, answered);
    if (method == "operation.load") return ask(load_operation(members), id, answered);
    if (method == "operation.run") return ask(RunOperation{RunOperation::How::run}, id, answered);
    if (method == "operation.step") return ask(RunOperation{RunOperation::How::step}, id, answered);
    if (method == "operation.resume") return ask(RunOperation{RunOperation::How::resume}, id, answered);
    if (method == "operation.pause") return ask(Pause{}, id, answered);
    if (method == "operation.stop") return ask(Stop{}, id, answered);
    if (method == "operation.from") return ask(PutToken{members.text("icon")}, id, answered);
    if (method == "operation.set") {
      const Json* value = members.find("value");
      if (value == nullptr) fail(bad_parameters, "'value' is missing");
      return ask(SetParameter{members.text("icon"), members.text("parameter"), value_of("value", *value)}, id,
                 answered);
    }
    if (method == "operation.break") return ask(SetBreakpoint{breakpoint(members)}, id, answered);
    if (method == "operation.clear") return ask(ClearBreakpoints{}, id, answered);
    fail(no_method, fmt::format("there is no method '{}'", method.substr(0, 60)));
  }

  void hello(const Members& members, const Json& id, bool answered) {
    if (client_) fail(bad_parameters, "hello has been said");
    if (!same_token(members.text("token"), lobby_.token)) {
      if (answered) refuse(id, not_admitted, "this is not the token");
      return mouth_.hang_up();
    }
    client_ = lobby_.desk.enter(members.text("name", "a client").substr(0, 60));
    Json json;
    json["protocol"] = 1;
    json.update(describe(lobby_.desk.status(*client_)));
    result(id, answered, json);
  }

  void watch(const Members& members, const Json& id, bool answered) {
    const Json* telemetry = members.find("telemetry");
    if (telemetry != nullptr) {
      if (!telemetry->is_number() || !(telemetry->get<double>() >= 0 && telemetry->get<double>() <= 3600))
        fail(bad_parameters, "'telemetry' is a period in seconds, 0 to 3600; 0: none");
      period_ = Duration(static_cast<std::int64_t>(telemetry->get<double>() * 1e9));
      due_ = {};
    }
    const Json* since = members.find("since");
    std::uint64_t number = lobby_.desk.status(*client_).last_event;
    if (since != nullptr) {
      if (!since->is_number_unsigned()) fail(bad_parameters, "'since' is the number of an event");
      number = since->get<std::uint64_t>();
    } else if (watching_) {
      number = said_;
    }
    const std::uint64_t first = lobby_.history.first();
    Json json;
    json["first_event"] = first;
    json["complete"] = first == 0 || number + 1 >= first;
    result(id, answered, json);
    watching_ = true;
    said_ = number;
    lobby_.history.since(number, [this](const Event& event) { notify(event); });
  }

  void ask(Command command, const Json& id, bool answered, bool skill = false) {
    lobby_.desk.ask(*client_, std::move(command),
                    [this, alive = std::weak_ptr(alive_), turn = lobby_.in_turn, id, answered,
                     skill](const Reply& reply) {
                      turn([this, alive, id, answered, skill, reply] {
                        const auto still = alive.lock();
                        if (!still || !*still || !answered) return;
                        if (const auto* refusal = std::get_if<Refusal>(&reply)) {
                          refuse(id, first_refusal + static_cast<int>(refusal->why), refusal->message);
                        } else {
                          result(id, true, describe(std::get<Done>(reply), skill));
                        }
                      });
                    });
  }

  void result(const Json& id, bool answered, const Json& json) {
    if (answered) mouth_.say(dump({{"jsonrpc", "2.0"}, {"id", id}, {"result", json}}));
  }
  void refuse(const Json& id, int code, const std::string& message) {
    mouth_.say(dump({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", message}}}}));
  }
  void notify(const Event& event) {
    said_ = event.number;
    mouth_.say(dump({{"jsonrpc", "2.0"}, {"method", "event"}, {"params", describe(event)}}));
  }

  Lobby& lobby_;
  Mouth mouth_;
  std::shared_ptr<bool> alive_;
  std::optional<ClientId> client_;
  bool watching_ = false;
  std::uint64_t said_ = 0;  // the last event that was sent
  Duration period_{}, due_{};
};

}  // namespace

std::unique_ptr<Session> json_session(Lobby& lobby, Mouth mouth) {
  return std::make_unique<JsonSession>(lobby, std::move(mouth));
}

}  // namespace pal::runtime_system
