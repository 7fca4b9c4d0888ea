// The dialogue with a client by lines (thesis, appendix A).
#include <fmt/format.h>

#include <deque>
#include <optional>
#include <utility>

#include "pal/support/text_width.hpp"
#include "server/line_commands.hpp"
#include "server/line_events.hpp"
#include "server/session.hpp"

namespace pal::server {
namespace {

constexpr std::size_t longest_line = 1000;
constexpr std::size_t largest_operation = std::size_t{1} << 20;
// How many characters a workstation reads after a '!'.
constexpr std::size_t message_size = 50;
// Lines that may wait for the check of an operation.
constexpr std::size_t most_held = 10'000;

class LineSession final : public Session {
 public:
  LineSession(SessionContext& context, SessionOutput output)
      : context_(context), output_(std::move(output)), alive_(std::make_shared<bool>(true)) {}
  ~LineSession() override {
    *alive_ = false;
    go();
  }

  void take(std::string_view bytes) override {
    for (const char byte : bytes) {
      if (byte == '\r' || byte == '\n') {
        const bool second = byte == '\n' && last_was_return_;
        last_was_return_ = byte == '\r';
        if (!second) end_line();
      } else {
        last_was_return_ = false;
        if (line_.size() <= (uploading() ? largest_operation : longest_line)) line_ += byte;
      }
    }
  }

  void happened(const Event& event, const std::string&) override {
    if (watching_) say(event_line(event));
    const auto* state = std::get_if<StateChanged>(&event.what);
    if (!waiting_ || state == nullptr || state->state == operations::ExecutionState::running) return;
    waiting_ = false;
    if (state->state == operations::ExecutionState::ended) {
      acknowledge(state->last_code);
    } else {
      complain(state->reason);
    }
  }
  void show(const std::shared_ptr<const Telemetry>& telemetry) override {
    if (!looks()) return;
    output_.send_sample({[telemetry](std::uint64_t) {
      std::string text = ">";
      for (const double figure : telemetry->force) text += fmt::format("{:8.2f}", figure).substr(0, 8);
      return text + "\r\n";
    }});
  }
  void show(Duration, const std::shared_ptr<const Profile>&) override {}
  bool admitted() const override { return client_.has_value(); }
  bool extra() const override { return extra_; }
  bool looks() const override { return client_ && (showing_ || show_this_); }

 private:
  bool uploading() const { return upload_.has_value(); }
  void go() {
    if (client_) context_.desk.leave(*client_);
    client_.reset();
    waiting_ = showing_ = show_this_ = watching_ = extra_ = loading_ = false;
    held_.clear();
    *alive_ = false;
    alive_ = std::make_shared<bool>(true);
  }

  void end_line() {
    const std::string line = std::exchange(line_, {});
    if (uploading()) return upload(line);
    // What follows the text of an operation waits until it is checked; a stop does not.
    if (loading_ && line != "stop" && line != "pause") {
      held_.push_back(line);
      if (held_.size() <= most_held) return;
      complain("too many lines wait");
      return output_.close("too many lines wait");
    }
    take_line(line);
  }

  void take_line(const std::string& line) {
    if (line.size() > longest_line)
      return complain(fmt::format("a line has at most {} characters", longest_line));
    const Words words = words_of(line);
    if (!words.empty()) obey(words);
  }

  void obey(const Words& words) {
    const std::string& verb = words.front();
    if (verb == "token") return token(words);
    if (!client_) {
      complain("say 'token' and the token first");
      return output_.close("no token was shown");
    }
    if (verb == "bye") {
      go();
      acknowledge(0);
      return output_.close("bye");
    }
    if (verb == "why") return tell(why_);
    if (verb == "state") return tell_state();
    if (verb == "skills") return tell_skills();
    if (verb == "sensors") return tell_sensors();
    if (verb == "data") return set(words, showing_);
    if (verb == "watch") return set(words, watching_);
    if (verb == "take") return ask(TakeControls{});
    if (verb == "release") return ask(ReleaseControls{});
    if (verb == "stop") return ask(Stop{});
    if (verb == "pause") return ask(Pause{});
    if (verb == "run") return run(RunOperation::How::run);
    if (verb == "step") return run(RunOperation::How::step);
    if (verb == "resume") return run(RunOperation::How::resume);
    if (verb == "clear") return ask(ClearBreakpoints{});
    if (verb == "load" && words.size() == 2) {
      upload_.emplace();
      upload_name_ = words[1];
      return;
    }
    if (verb == "answer" && words.size() >= 3) return ask(answer_of(words));
    if (verb == "from" && words.size() == 2) return ask(PutToken{words[1]});
    if (verb == "break" && (words.size() == 2 || words.size() == 3)) return ask_as(set_breakpoint_of(words));
    if (verb == "set" && words.size() == 4) return ask(set_parameter_of(words));
    const auto skill = context_.desk.skills().find(verb);
    if (skill == context_.desk.skills().end()) return complain(fmt::format("no skill or command '{}'", verb));
    run_skill(skill->second, words);
  }

  void token(const Words& words) {
    if (client_) return complain("the token has been shown");
    const auto role = context_.tokens.role_of(words.size() < 2 ? std::string() : words[1]);
    if (!role) {
      complain("this is not the token");
      return output_.close("a wrong token");
    }
    extra_ = context_.full && context_.full();
    client_ = context_.desk.enter(words.size() > 2 ? words[2].substr(0, 60) : "a line",
                                  extra_ ? Role::viewer : *role);
    acknowledge(0);
  }

  void run_skill(const pan::Template& skill, Words words) {
    const bool show = words.back() == "show";
    if (show) words.pop_back();
    ask_as(run_skill_of(skill, words), show);
  }
  template <class What>
  void ask_as(FromWords<What> command, bool show = false) {
    if (const auto* wrong = std::get_if<std::string>(&command)) return complain(*wrong);
    ask(std::get<What>(std::move(command)), show);
  }

  void upload(const std::string& line) {
    if (line == ".") {
      const std::string text = *std::exchange(upload_, std::nullopt);
      if (text.size() > largest_operation) return complain("an operation has at most 1 MiB");
      return load({{{upload_name_, text}}, upload_name_});
    }
    if (upload_->size() <= largest_operation) *upload_ += line + "\n";
  }

  /// Beside the desk, for the check takes its time.
  void load(LoadOperation command) {
    loading_ = true;
    const auto answer = in_turn([this](const Reply& reply) {
      loading_ = false;
      if (const auto* refusal = std::get_if<Refusal>(&reply)) {
        complain(refusal->text());
      } else {
        acknowledge(0);
      }
      while (!loading_ && !uploading() && !held_.empty()) {
        const std::string line = std::move(held_.front());
        held_.pop_front();
        if (client_) end_held(line);
      }
    });
    const auto ticket = context_.checks.submit(
        *client_,
        [&desk = context_.desk, client = *client_, command = std::move(command),
         answer](const Workshop::Stop& stop) mutable { desk.ask(client, std::move(command), answer, stop); });
    if (ticket) return;
    loading_ = false;
    complain("too many texts of this client wait");
  }
  void end_held(const std::string& line) {
    if (uploading()) return upload(line);
    take_line(line);
  }

  /// Answered when it halts.
  void run(RunOperation::How how) {
    if (waiting_) return complain("an operation runs; pause or stop it first");
    waiting_ = true;
    context_.desk.ask(*client_, RunOperation{how}, in_turn([this](const Reply& reply) {
      const auto* refusal = std::get_if<Refusal>(&reply);
      if (refusal == nullptr) return;
      waiting_ = false;
      complain(refusal->text());
    }));
  }
  void ask(Command command, bool show = false) {
    if (show) {
      show_this_ = true;
      look_otherwise();
    }
    const bool skill = std::holds_alternative<RunSkill>(command);
    context_.desk.ask(*client_, std::move(command), in_turn([this, skill](const Reply& reply) {
      if (skill) show_this_ = false;
      if (const auto* refusal = std::get_if<Refusal>(&reply)) return complain(refusal->text());
      const auto& result = std::get<Done>(reply).result;
      if (result.kind == operations::SkillResult::Kind::stopped) return complain(result.reason);
      why_ = result.reason;
      acknowledge(result.code);
    }));
  }
  Answerer in_turn(std::function<void(const Reply&)> use) {
    return
        [alive = std::weak_ptr(alive_), turn = context_.in_turn, use = std::move(use)](const Reply& reply) {
          turn([alive, use, reply] {
            const auto still = alive.lock();
            if (still && *still) use(reply);
          });
        };
  }

  void set(const Words& words, bool& what) {
    if (words.size() != 2 || (words[1] != "on" && words[1] != "off"))
      return complain(fmt::format("write {} on, or {} off", words[0], words[0]));
    what = words[1] == "on";
    look_otherwise();
    acknowledge(0);
  }
  void look_otherwise() {
    if (context_.looks_otherwise) context_.looks_otherwise();
  }
  void tell_state() {
    const Status status = context_.desk.status(*client_);
    tell(fmt::format("{} {} {} at {} code {} steps {} controls {}", name(status.activity),
                     status.operation.empty() ? "-" : status.operation, operations::name(status.state),
                     status.token.empty() ? "-" : status.token, status.last_code, status.steps,
                     status.holder.empty() ? "-" : status.holder));
  }
  void tell_skills() {
    for (const auto& [name, skill] : context_.desk.skills()) {
      std::string text = name;
      for (const pan::Parameter& parameter : skill.parameters) text += " " + parameter.name;
      tell(text);
    }
    acknowledge(0);
  }
  void tell_sensors() {
    for (const auto& [name, sensor] : context_.desk.sensors())
      tell(sensor.unit.empty() ? name : name + " " + sensor.unit);
    acknowledge(0);
  }
  void acknowledge(int code) { say(fmt::format("#{}", code)); }
  void complain(const std::string& message) {
    why_ = message;
    say(fmt::format("!{:<{}}", message.substr(0, message_size), message_size));
  }
  void tell(const std::string& text) { say("=" + text); }
  /// Names of operations and icons come from other clients: nothing in them commands this one's terminal.
  void say(std::string text) {
    for (char& each : text)
      if (each == '\n' || each == '\r') each = ' ';
    output_.send(printable(text) + "\r\n");
  }

  SessionContext& context_;
  SessionOutput output_;
  std::shared_ptr<bool> alive_;
  std::optional<ClientId> client_;
  std::string line_, why_, upload_name_;
  std::optional<std::string> upload_;
  std::deque<std::string> held_;  // lines that wait
  bool last_was_return_ = false;
  bool loading_ = false;    // an operation is being checked
  bool extra_ = false;      // it may look, pause and stop
  bool waiting_ = false;    // for the operation to halt
  bool showing_ = false;    // forces are wanted
  bool show_this_ = false;  // … until the skill ends
  bool watching_ = false;
};

}  // namespace

std::unique_ptr<Session> line_session(SessionContext& context, SessionOutput output) {
  return std::make_unique<LineSession>(context, std::move(output));
}

}  // namespace pal::server
