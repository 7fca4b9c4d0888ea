// The dialogue with a client by JSON-RPC.
#include <fmt/format.h>

#include <deque>
#include <map>
#include <optional>
#include <utility>

#include "server/access.hpp"
#include "server/json_call.hpp"
#include "server/session.hpp"

namespace pal::server {
namespace {

class JsonSession final : public Session, private CallHome {
 public:
  JsonSession(SessionContext& context, SessionOutput output)
      : context_(context), output_(std::move(output)), alive_(std::make_shared<bool>(true)) {}
  ~JsonSession() override {
    *alive_ = false;
    for (const auto& [id, ticket] : tickets_) *ticket = true;
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
      obey(method->get<std::string>(), Call(*this, Members(request), id, answered));
    } catch (const Problem& problem) {
      if (answered) send_problem(id, problem);
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
  bool extra() const override { return extra_; }
  bool looks() const override { return period_ > Duration::zero(); }

 private:
  // For calls.
  SessionContext& context() override { return context_; }
  ClientId client() const override { return client_.value_or(0); }
  Role role() const override { return role_; }
  void send_result(const Json& id, const Json& result) override {
    output_.send(dump({{"jsonrpc", "2.0"}, {"id", id}, {"result", result}}));
  }
  void send_problem(const Json& id, const Problem& problem) override {
    output_.send(
        dump({{"jsonrpc", "2.0"},
              {"id", id},
              {"error", {{"code", problem.code}, {"message", problem.message}, {"data", problem.data}}}}));
  }
  void note_ticket(const Json& id, const Workshop::Ticket& ticket) override {
    const std::string name = dump(id);
    if (ticket) {
      tickets_[name] = ticket;
    } else {
      tickets_.erase(name);
    }
  }
  void hold_commands(bool hold) override {
    holding_ = hold;
    while (!holding_ && !held_.empty()) {
      const auto [method, call] = std::move(held_.front());
      held_.pop_front();
      try {
        method->answer(call);
      } catch (const Problem& problem) {
        call.refuse(problem);
      }
    }
  }
  std::weak_ptr<bool> alive() const override { return alive_; }

  void obey(const std::string& name, const Call& call) {
    if (name == "hello") return hello(call);
    if (!client_) {
      call.refuse(problem_of(not_admitted, "say hello with the token first"));
      return output_.close("no token was shown");
    }
    if (name == "watch") return watch(call);
    if (name == "cancel") return cancel(call);
    const Method* method = find_method(name);
    if (method == nullptr) fail(no_method, fmt::format("there is no method '{}'", name.substr(0, 60)));
    if (role_ < method->least)
      fail(Refusal::Why::role,
           fmt::format("a{} {} may not do that", role_ == Role::operating ? "n" : "",
                       pal::server::name(role_)),
           extra_ ? "the places for clients are taken: look, pause and stop"
                  : fmt::format("show the token of a{} {}", method->least == Role::operating ? "n" : "",
                                pal::server::name(method->least)));
    // A text of a client may wait for its check as long as others of its own.
    if (!holding_ || !method->commands) return method->answer(call);
    if (held_.size() >= Workshop::most_waiting)
      fail(Refusal::Why::too_much, "too many requests of this client wait", "wait for their answers");
    held_.emplace_back(method, call);
  }

  void hello(const Call& call) {
    if (client_) fail(bad_parameters, "hello has been said");
    const Members& members = call.members();
    const auto given = context_.tokens.role_of(members.text("token"));
    if (!given) {
      call.refuse(problem_of(not_admitted, "this is not the token", "the server's announcement has it"));
      return output_.close("a wrong token");
    }
    const std::string wanted = members.text("role", "");
    const auto role = wanted.empty() ? given : role_named(wanted);
    if (!role) fail(bad_parameters, "'role' is viewer, operator or programmer");
    if (*role > *given)
      fail(Refusal::Why::role, fmt::format("this token is that of a {}", pal::server::name(*given)),
           "show another token, or ask for less");
    extra_ = context_.full && context_.full();
    role_ = extra_ ? Role::viewer : *role;
    client_ = context_.desk.enter(members.text("name", "a client").substr(0, 60), role_);
    call.result(snapshot_json(context_, *client_));
  }

  void watch(const Call& call) {
    const Members& members = call.members();
    const Json* telemetry = members.find("telemetry");
    if (telemetry != nullptr &&
        (!telemetry->is_number() || !(telemetry->get<double>() >= 0 && telemetry->get<double>() <= 3600)))
      fail(bad_parameters, "'telemetry' is a period in seconds, 0 to 3600; 0: none");
    const Json* since = members.find("since");
    if (since != nullptr && !since->is_number_unsigned())
      fail(bad_parameters, "'since' is the number of an event");
    const std::string epoch = members.text("epoch", context_.desk.epoch().c_str());
    if (telemetry != nullptr) {
      period_ = Duration(static_cast<std::int64_t>(telemetry->get<double>() * 1e9));
      due_ = {};
    }
    const std::uint64_t last = context_.desk.status(*client_).last_event;
    std::uint64_t number = last;
    if (since != nullptr) {
      number = since->get<std::uint64_t>();
    } else if (watching_) {
      number = said_;
    }
    const std::uint64_t first = context_.history.first();
    // A number that has not come yet is of another server.
    bool complete = epoch == context_.desk.epoch() && number <= last && (first == 0 || number + 1 >= first);
    Json json;
    json["first_event"] = first;
    json["complete"] = complete;
    json["epoch"] = context_.desk.epoch();
    if (!complete) {
      json["snapshot"] = snapshot_json(context_, *client_);
      number = json["snapshot"]["last_event"].get<std::uint64_t>();
      // A client of the first protocol wants the events that are still known.
      if (members.find("epoch") == nullptr && since != nullptr && since->get<std::uint64_t>() <= last)
        number = since->get<std::uint64_t>();
    }
    call.result(json);
    watching_ = true;
    said_ = number;
    context_.history.since(number, [this](const Event& event) { notify(event); });
  }

  void cancel(const Call& call) {
    const Json* request = call.members().find("request");
    if (request == nullptr || !(request->is_string() || request->is_number()))
      fail(bad_parameters, "'request' is the id of a request");
    const auto found = tickets_.find(dump(*request));
    if (found != tickets_.end()) *found->second = true;
    call.result({{"found", found != tickets_.end()}});
  }

  void notify(const Event& event) {
    said_ = event.number;
    output_.send(dump({{"jsonrpc", "2.0"}, {"method", "event"}, {"params", describe(event)}}));
  }

  SessionContext& context_;
  SessionOutput output_;
  std::shared_ptr<bool> alive_;
  std::optional<ClientId> client_;
  Role role_ = Role::viewer;
  bool extra_ = false;
  bool watching_ = false;
  std::uint64_t said_ = 0;  // the last event that was sent
  Duration period_{}, due_{};
  std::map<std::string, Workshop::Ticket> tickets_;  // by the ids of requests that are not answered
  bool holding_ = false;
  std::deque<std::pair<const Method*, Call>> held_;
};

}  // namespace

std::optional<Role> Tokens::role_of(std::string_view given) const {
  const bool is_programmer = same_token(given, programmer), is_operating = same_token(given, operating),
             is_viewer = same_token(given, viewer);
  if (is_programmer) return Role::programmer;
  if (is_operating) return Role::operating;
  if (is_viewer) return Role::viewer;
  return std::nullopt;
}

std::unique_ptr<Session> json_session(SessionContext& context, SessionOutput output) {
  return std::make_unique<JsonSession>(context, std::move(output));
}

}  // namespace pal::server
