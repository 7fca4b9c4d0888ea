// The dialogue with a client by JSON-RPC.
#include <fmt/format.h>

#include <optional>
#include <utility>

#include "server/access.hpp"
#include "server/json_requests.hpp"
#include "server/json_values.hpp"
#include "server/session.hpp"

namespace pal::server {
namespace {

class JsonSession final : public Session {
 public:
  JsonSession(SessionContext& context, SessionOutput output)
      : context_(context), output_(std::move(output)), alive_(std::make_shared<bool>(true)) {}
  ~JsonSession() override {
    *alive_ = false;
    if (client_) context_.desk.leave(*client_);
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
    output_.send_sample([telemetry](std::uint64_t dropped) {
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
    output_.send_sample([time, profile](std::uint64_t dropped) {
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
      return output_.close();
    }
    if (method == "state") return result(id, answered, describe(context_.desk.status(*client_)));
    if (method == "skills") return result(id, answered, describe(context_.desk.skills()));
    if (method == "sensors") return result(id, answered, describe(context_.desk.sensors()));
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
    if (method == "operation.set") return ask(set_parameter(members), id, answered);
    if (method == "operation.break") return ask(SetBreakpoint{breakpoint(members)}, id, answered);
    if (method == "operation.clear") return ask(ClearBreakpoints{}, id, answered);
    fail(no_method, fmt::format("there is no method '{}'", method.substr(0, 60)));
  }

  void hello(const Members& members, const Json& id, bool answered) {
    if (client_) fail(bad_parameters, "hello has been said");
    if (!same_token(members.text("token"), context_.token)) {
      if (answered) refuse(id, not_admitted, "this is not the token");
      return output_.close();
    }
    client_ = context_.desk.enter(members.text("name", "a client").substr(0, 60));
    Json json;
    json["protocol"] = 1;
    json.update(describe(context_.desk.status(*client_)));
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
    std::uint64_t number = context_.desk.status(*client_).last_event;
    if (since != nullptr) {
      if (!since->is_number_unsigned()) fail(bad_parameters, "'since' is the number of an event");
      number = since->get<std::uint64_t>();
    } else if (watching_) {
      number = said_;
    }
    const std::uint64_t first = context_.history.first();
    Json json;
    json["first_event"] = first;
    json["complete"] = first == 0 || number + 1 >= first;
    result(id, answered, json);
    watching_ = true;
    said_ = number;
    context_.history.since(number, [this](const Event& event) { notify(event); });
  }

  void ask(Command command, const Json& id, bool answered, bool skill = false) {
    context_.desk.ask(*client_, std::move(command),
                      [this, alive = std::weak_ptr(alive_), turn = context_.in_turn, id, answered,
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
    if (answered) output_.send(dump({{"jsonrpc", "2.0"}, {"id", id}, {"result", json}}));
  }
  void refuse(const Json& id, int code, const std::string& message) {
    output_.send(dump({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", message}}}}));
  }
  void notify(const Event& event) {
    said_ = event.number;
    output_.send(dump({{"jsonrpc", "2.0"}, {"method", "event"}, {"params", describe(event)}}));
  }

  SessionContext& context_;
  SessionOutput output_;
  std::shared_ptr<bool> alive_;
  std::optional<ClientId> client_;
  bool watching_ = false;
  std::uint64_t said_ = 0;  // the last event that was sent
  Duration period_{}, due_{};
};

}  // namespace

std::unique_ptr<Session> json_session(SessionContext& context, SessionOutput output) {
  return std::make_unique<JsonSession>(context, std::move(output));
}

}  // namespace pal::server
