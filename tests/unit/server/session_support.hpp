// A session without a socket.
#pragma once

#include "server/json_events.hpp"
#include "server/session.hpp"
#include "tests/unit/server/support.hpp"

namespace pal::test {

/// A desk, a history and one session, these two in the test's thread. The cell works when it is told to; a
/// test may do that in another thread.
struct SessionFixture : server::EventSink {
  using Make = std::unique_ptr<server::Session> (*)(server::SessionContext&, server::SessionOutput);

  explicit SessionFixture(Make make, const server::DeskOptions& options = {})
      : desk{cell, clockwork_skills(), *this, options}, make_(make) {
    open();
  }
  void open() {
    hung_up = false;
    session = make_(context, {[this](std::string text) { said.push_back(std::move(text)); },
                              [this](const server::LiveMessage& message) { said.push_back(message.make(0)); },
                              [this](std::string reason) {
                                hung_up = true;
                                why = std::move(reason);
                              }});
  }
  /// In any thread, as for a server: history and session get it by deliver().
  void happened(const server::Event& event) override {
    const std::lock_guard lock(mutex);
    waiting.push_back(event);
  }
  /// What is said to this text, with events that came of it.
  std::vector<std::string> say(const std::string& text) {
    said.clear();
    session->take(text);
    deliver();
    return said;
  }
  /// Likewise, of what the cell does.
  std::vector<std::string> work() {
    said.clear();
    while (desk.work()) {
    }
    deliver();
    return said;
  }
  void deliver() {
    std::vector<server::Event> taken;
    {
      const std::lock_guard lock(mutex);
      taken = std::exchange(waiting, {});
    }
    for (const server::Event& event : taken) {
      const std::string told = server::event_text(event);
      history.add(event.number, told);
      session->happened(event, told);
    }
  }

  Clockwork cell;
  server::History history;
  std::mutex mutex;
  std::vector<server::Event> waiting;  // with the mutex
  server::Desk desk;
  server::Workshop at_once{false};
  server::SessionContext context{desk,
                                 history,
                                 {"secret", "operators", "viewers"},
                                 [](const std::function<void()>& action) { action(); },
                                 at_once,
                                 at_once,
                                 at_once};
  std::vector<std::string> said;
  bool hung_up = false;
  std::string why;  // it hung up
  std::unique_ptr<server::Session> session;

 private:
  Make make_;
};

}  // namespace pal::test
