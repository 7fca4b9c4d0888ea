// The dialogue with a client by JSON-RPC.
#include <fmt/format.h>

#include <deque>
#include <map>
#include <optional>
#include <utility>

#include "server/access.hpp"
#include "server/json_call.hpp"
#include "server/json_live.hpp"
#include "server/session.hpp"

namespace pal::server {
namespace {

constexpr std::size_t longest_read_at_once = std::size_t{16} << 10;
constexpr const char* too_many_wait = "too many requests of this client wait";
constexpr const char* wait_for_answers = "wait for their answers";

class JsonSession final : public Session, private CallHome {
 public:
  JsonSession(SessionContext& context, SessionOutput output)
      : context_(context),
        output_(std::move(output)),
        alive_(std::make_shared<bool>(true)),
        live_(output_, context.channels, context.latest) {}
  ~JsonSession() override {
    *alive_ = false;
    for (const auto& [id, ticket] : tickets_) *ticket = true;
    if (client_) context_.desk.leave(*client_);
  }

  void take(std::string_view text) override {
    // The thread of the sockets is for short messages: what is long keeps no stop waiting.
    if (!client_ || text.size() <= longest_read_at_once) return obey(read_request(text));
    const auto place = std::make_shared<Held>();
    held_.push_back(place);
    const auto ticket = context_.reading.submit(
        *client_, [this, place, text = std::string(text), alive = std::weak_ptr(alive_),
                   turn = context_.in_turn](const Workshop::Stop&) {
          turn([this, place, alive, request = std::make_shared<ParsedRequest>(read_request(text))] {
            const auto still = alive.lock();
            if (still && *still) obey_long(place, *request);
          });
        });
    if (ticket) return;
    std::erase(held_, place);
    send_problem(nullptr, problem_of(Refusal{Refusal::Why::too_much, too_many_wait, wait_for_answers}));
  }

  void happened(const Event& event, const std::string& told) override {
    if (watching_ && event.number > said_) notify(event.number, told);
  }
  void show(const std::shared_ptr<const Telemetry>& telemetry) override { live_.show(telemetry); }
  void show(Duration time, const std::shared_ptr<const Profile>& profile) override {
    live_.show(time, profile);
  }
  void show(const ShownBlock& block) override { live_.show(block); }
  void show(const std::shared_ptr<const Rows>& rows) override { live_.show(rows); }
  void catch_up() override { live_.catch_up(); }
  bool admitted() const override { return client_.has_value(); }
  bool extra() const override { return extra_; }
  bool looks() const override { return live_.looks(); }
  bool watches_channels() const override { return live_.watches_channels(); }

 private:
  // For calls.
  SessionContext& context() override { return context_; }
  ClientId client() const override { return client_.value_or(0); }
  Role role() const override { return role_; }
  void send_result(const Json& id, const Json& result) override { send_message(answer_text(id, result)); }
  void send_message(std::string message) override { output_.send(std::move(message)); }
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
    advance();
  }
  std::weak_ptr<bool> alive() const override { return alive_; }

  /// A command that waits for what came before it.
  struct Held {
    std::optional<std::pair<const Method*, Call>> request;  // nothing: it is still being read
  };

  void obey(const ParsedRequest& request) {
    answer(request, [&](const Method& method, const Call& call) {
      if (!method.commands || (!holding_ && held_.empty())) return method.answer(call);
      if (held_.size() >= Workshop::most_waiting)
        fail(Refusal::Why::too_much, too_many_wait, wait_for_answers);
      held_.push_back(std::make_shared<Held>(Held{std::pair(&method, call)}));
    });
  }
  /// Its place among the commands was kept.
  void obey_long(const std::shared_ptr<Held>& place, const ParsedRequest& request) {
    answer(request, [&](const Method& method, const Call& call) {
      if (!method.commands) return method.answer(call);
      place->request.emplace(&method, call);
    });
    if (!place->request) std::erase(held_, place);
    advance();
  }
  void advance() {
    while (!holding_ && !held_.empty() && held_.front()->request) {
      const auto [method, call] = *held_.front()->request;
      held_.pop_front();
      try {
        method->answer(call);
      } catch (const Problem& problem) {
        call.refuse(problem);
      }
    }
  }

  /// Refuses what is no request, and what this client may not ask; gives the rest to `use`.
  template <class Use>
  void answer(const ParsedRequest& request, const Use& use) {
    const Call call(*this, request.members, request.id, request.answered);
    if (request.problem) return call.refuse(*request.problem);
    try {
      if (const Method* method = method_for(request.method, call)) use(*method, call);
    } catch (const Problem& problem) {
      call.refuse(problem);
    }
  }
  /// Null: the session itself has answered.
  const Method* method_for(const std::string& name, const Call& call) {
    if (name == "hello") return hello(call);
    if (!client_) {
      call.refuse(problem_of(not_admitted, "say hello with the token first"));
      output_.close("no token was shown");
      return nullptr;
    }
    if (name == "watch") return watch(call);
    if (name == "cancel") return cancel(call);
    if (name == "channels.watch") return watch_channels(call);
    const Method* method = find_method(name);
    if (method == nullptr) fail(no_method, fmt::format("there is no method '{}'", name.substr(0, 60)));
    if (role_ < method->least)
      fail(Refusal::Why::role,
           fmt::format("a{} {} may not do that", role_ == Role::operating ? "n" : "",
                       pal::server::name(role_)),
           extra_ ? "the places for clients are taken: look, pause and stop"
                  : fmt::format("show the token of a{} {}", method->least == Role::operating ? "n" : "",
                                pal::server::name(method->least)));
    return method;
  }

  std::nullptr_t hello(const Call& call) {
    if (client_) fail(bad_parameters, "hello has been said");
    const Members& members = call.members();
    const auto given = context_.tokens.role_of(members.text("token"));
    if (!given) {
      call.refuse(problem_of(not_admitted, "this is not the token", "the server's announcement has it"));
      output_.close("a wrong token");
      return nullptr;
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
    return nullptr;
  }

  std::nullptr_t watch(const Call& call) {
    const Members& members = call.members();
    const Json* telemetry = members.find("telemetry");
    if (telemetry != nullptr &&
        (!telemetry->is_number() || !(telemetry->get<double>() >= 0 && telemetry->get<double>() <= 3600)))
      fail(bad_parameters, "'telemetry' is a period in seconds, 0 to 3600; 0: none");
    const Json* since = members.find("since");
    if (since != nullptr && !since->is_number_unsigned())
      fail(bad_parameters, "'since' is the number of an event");
    const std::string epoch = members.text("epoch", context_.desk.epoch().c_str());
    if (telemetry != nullptr)
      live_.watch_telemetry(Duration(static_cast<std::int64_t>(telemetry->get<double>() * 1e9)));
    if (context_.looks_otherwise) context_.looks_otherwise();
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
    context_.history.since(number,
                           [this](std::uint64_t each, const std::string& told) { notify(each, told); });
    return nullptr;
  }

  std::nullptr_t cancel(const Call& call) {
    const Json* request = call.members().find("request");
    if (request == nullptr || !(request->is_string() || request->is_number()))
      fail(bad_parameters, "'request' is the id of a request");
    const auto found = tickets_.find(dump(*request));
    if (found != tickets_.end()) *found->second = true;
    call.result({{"found", found != tickets_.end()}});
    return nullptr;
  }

  std::nullptr_t watch_channels(const Call& call) {
    live_.watch_channels(call.members());
    if (context_.looks_otherwise) context_.looks_otherwise();
    call.result(Json::object());
    live_.begin();
    return nullptr;
  }

  void notify(std::uint64_t number, const std::string& told) {
    said_ = number;
    output_.send(R"({"jsonrpc":"2.0","method":"event","params":)" + told + "}");
  }

  SessionContext& context_;
  SessionOutput output_;
  std::shared_ptr<bool> alive_;
  std::optional<ClientId> client_;
  Role role_ = Role::viewer;
  bool extra_ = false;
  bool watching_ = false;
  std::uint64_t said_ = 0;  // the last event that was sent
  LiveView live_;
  std::map<std::string, Workshop::Ticket> tickets_;  // by the ids of requests that are not answered
  bool holding_ = false;
  std::deque<std::shared_ptr<Held>> held_;
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
