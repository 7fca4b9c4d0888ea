// A session of the server, fed with any bytes.
#pragma once

#include <cstdlib>
#include <string>
#include <string_view>

#include "server/json_events.hpp"
#include "server/session.hpp"

namespace pal::fuzz {

/// Counts what moves; nothing lasts.
class Counting final : public operations::SkillRunner {
 public:
  operations::SkillResult run(const std::string&, const std::vector<operations::Parameter>&,
                              std::optional<Duration>) override {
    ++moved;
    if (moved > 100) desk->end();  // an endless operation
    return {};
  }
  bool delay(Duration length) override {
    time_ += length;
    if (++waited_ > 100) desk->end();
    return !stopped_;
  }
  operations::Reading sense(const std::string&) override {
    time_ += std::chrono::milliseconds(10);
    if (++waited_ > 100) desk->end();
    return {static_cast<double>(waited_ % 5), {}, stopped_};
  }
  Duration now() const override { return time_; }
  void stop() noexcept override { stopped_ = true; }
  void allow() override { stopped_ = false; }
  int moved = 0;
  server::Desk* desk = nullptr;

 private:
  Duration time_{};
  int waited_ = 0;
  bool stopped_ = false;
};

class FuzzedSession final : public server::EventSink {
 public:
  using Make = std::unique_ptr<server::Session> (*)(server::SessionContext&, server::SessionOutput);

  explicit FuzzedSession(Make make)
      : session(make(context,
                     {[](const std::string&) {}, [](const server::LiveMessage& message) { message.make(0); },
                      [this](const std::string&) { hung_up = true; }})) {
    runner.desk = &desk;
  }
  void happened(const server::Event& event) override {
    history.add(event.number, server::event_text(event));
    waiting.push_back(event);
  }
  /// One message, and what the cell makes of it. Nothing may move before the token has been shown.
  void give(std::string_view text) {
    if (hung_up) return;
    session->take(text);
    desk.work();
    for (const auto& event : std::exchange(waiting, {})) session->happened(event, server::event_text(event));
    if (!session->admitted() && !was_admitted && runner.moved > 0) std::abort();
    was_admitted = was_admitted || session->admitted();
  }

  static server::DeskOptions options() {
    server::DeskOptions result;
    result.sensors = {{"eye", {"mm", "what it sees"}}};
    return result;
  }
  static operations::Skills skills() {
    pan::Template skill;
    skill.name = "rub";
    pan::Parameter number, text, truth;
    number.name = "distance";
    number.high = 50;
    text.name = "location";
    text.type = pan::ScalarType::text;
    truth.name = "band-rule";
    truth.type = pan::ScalarType::boolean;
    skill.parameters = {number, text, truth};
    skill.completions.resize(2);
    skill.completions[1].code = 1;
    skill.completions[1].kind = pan::Completion::Kind::error;
    return {{"rub", skill}};
  }

  Counting runner;
  server::History history;
  std::vector<server::Event> waiting;
  server::Desk desk{runner, skills(), *this, options()};
  server::Workshop at_once{false};
  server::SessionContext context{desk,
                                 history,
                                 {"0123456789abcdef0123456789abcdef", "", ""},
                                 [](const std::function<void()>& action) { action(); },
                                 at_once,
                                 at_once,
                                 at_once};
  bool hung_up = false, was_admitted = false;
  std::unique_ptr<server::Session> session;
};

}  // namespace pal::fuzz
