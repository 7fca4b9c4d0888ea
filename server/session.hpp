// The dialogue with one client by one of the two protocols, without its socket: text in, text out.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "server/channels.hpp"
#include "server/desk.hpp"
#include "server/history.hpp"
#include "server/knowledge.hpp"
#include "server/outbox.hpp"
#include "server/run_recording.hpp"
#include "server/scene.hpp"
#include "server/store.hpp"
#include "server/study.hpp"
#include "server/telemetry.hpp"
#include "server/workshop.hpp"

namespace pal::server {

/// By which a client shows what it may do. Empty: there is none of this role.
struct Tokens {
  std::string programmer, operating, viewer;

  /// Takes the same time wherever the first difference is. Nothing: it is no token.
  std::optional<Role> role_of(std::string_view given) const;
};

/// What all sessions share.
struct SessionContext {
  Desk& desk;
  const History& history;
  Tokens tokens;
  /// Runs the function in the thread of the sessions: answers of the desk come from other threads. It may run
  /// it at once, or later; or never, when the server ends.
  std::function<void(std::function<void()>)> in_turn;
  Workshop& checks;  // of texts
  Workshop& disk;
  Workshop& reading;                        // of long messages
  Store* store = nullptr;                   // null: this server has none
  Knowledge* knowledge = nullptr;           // null: nothing is known of skills but what running needs
  std::string version{};                    // of the program
  const RunHistory* runs = nullptr;         // null: no history is kept
  const Channels* channels = nullptr;       // null: this cell has none
  Workshop* studies = nullptr;              // of trials
  Trials* trials = nullptr;                 // null: nothing can be tried aside
  const Scene* scene = nullptr;             // null: what the cell looks like is not told
  const RunRecording* recording = nullptr;  // null: no run is recorded
  /// The last rows of each channel that has such.
  const std::map<std::string, std::shared_ptr<const Rows>>* latest = nullptr;
  /// Whether the places for clients that may do anything are taken. The next one may look, pause and stop.
  std::function<bool()> full{};
  /// A session asks for live data, or for others, from now on: a skill that its client begins next is seen
  /// from its beginning.
  std::function<void()> looks_otherwise{};

  std::shared_ptr<const Facts> facts() const {
    return knowledge != nullptr ? knowledge->now() : std::make_shared<const Facts>();
  }
};

/// Where a session's texts go. These functions must not throw, nor call the session.
struct SessionOutput {
  /// Answers and events: never left out.
  std::function<void(std::string)> send;
  /// Live data; the message is made when it is sent.
  std::function<void(LiveMessage)> send_sample;
  /// No more is read from this client; what was sent before still reaches it. The reason is a few words.
  std::function<void(std::string reason)> close;
};

/// One thread only. Its end is the client's going.
class Session {
 public:
  virtual ~Session() = default;
  /// Whatever the client sent: a message of the WebSocket, some bytes of a line. Never throws for what is in
  /// it.
  virtual void take(std::string_view text) = 0;
  /// `told`: the same, as event_text() tells it, once for all sessions.
  virtual void happened(const Event& event, const std::string& told) = 0;
  virtual void show(const std::shared_ptr<const Telemetry>& telemetry) = 0;
  virtual void show(Duration time, const std::shared_ptr<const Profile>& profile) = 0;
  virtual void show(const ShownBlock&) {}
  virtual void show(const std::shared_ptr<const Rows>&) {}
  /// Some time has passed: what waited for something newer is sent.
  virtual void catch_up() {}
  /// It has shown the token.
  virtual bool admitted() const = 0;
  /// It came when the places were taken, and may look, pause and stop.
  virtual bool extra() const = 0;
  /// It wants telemetry.
  virtual bool looks() const = 0;
  /// It wants samples of channels.
  virtual bool watches_channels() const { return false; }
};

/// JSON-RPC 2.0 (docs/reference/protocols.md). The context and what the output calls outlive it.
std::unique_ptr<Session> json_session(SessionContext& context, SessionOutput output);
/// The lines of the thesis (appendix A). Likewise.
std::unique_ptr<Session> line_session(SessionContext& context, SessionOutput output);

}  // namespace pal::server
