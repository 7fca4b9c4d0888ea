// The server: it listens at a WebSocket, and for lines over TCP, a pseudo-terminal or a serial port. One
// thread of its own.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/access.hpp"
#include "server/desk.hpp"
#include "server/event.hpp"
#include "server/outbox.hpp"
#include "server/page_files.hpp"
#include "server/session.hpp"
#include "server/telemetry.hpp"

namespace pal::server {

struct ServerOptions {
  std::string address = "127.0.0.1";       // of the WebSocket and of lines over TCP
  std::uint16_t port = 0;                  // of the WebSocket; 0: any that is free
  std::optional<std::uint16_t> line_port;  // lines over TCP; 0: any that is free
  bool line_terminal = false;              // lines over a pseudo-terminal
  std::string line_serial;                 // lines over this serial port; empty: none
  unsigned baud = 9600;                    // of the serial port
  Tokens tokens;
  AccessRules access;             // its port is filled in
  std::size_t most_clients = 16;  // that have shown a token and may do what their role may
  std::size_t most_extra = 4;     // beyond these: they may look, pause and stop; the oldest goes first
  std::size_t most_unknown = 32;  // that have shown no token yet; likewise
  std::chrono::milliseconds admit_within = std::chrono::seconds(10);  // from coming to showing the token
  std::chrono::milliseconds idle =
      std::chrono::seconds(30);  // a WebSocket that does not answer a ping is closed
  OutboxLimits outbox;
  std::vector<PageFolder> pages;      // for browsers
  Store* store = nullptr;             // operations on the disk; null: none
  Knowledge* knowledge = nullptr;     // of skills; null: none
  const RunHistory* runs = nullptr;   // null: no history is kept
  Trials* trials = nullptr;           // null: nothing can be tried aside
  const Scene* scene = nullptr;       // whole when the server starts; null: it is not told
  RunRecording* recording = nullptr;  // null: no run is recorded
  Channels channels;                  // of live data
  std::string version;                // of the program
};

/// Keeps slow clients from the cell: it is only ever given a copy, and the rest is done in the server's
/// thread.
class Server final : public EventSink, public TelemetrySink {
 public:
  /// Opens all ports; no client is answered before start(). Throws std::runtime_error with the system's
  /// reason.
  explicit Server(ServerOptions options);
  /// As stop().
  ~Server() override;
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Serves from now on, until stop(); the desk, which has this as its sink, lives as long. With `signals`
  /// SIGINT, SIGTERM, SIGHUP and SIGQUIT end the desk; those that are ignored stay so.
  void start(Desk& desk, bool signals = false);
  /// Ends the service and the thread.
  void stop();

  std::uint16_t port() const;
  /// Of lines over TCP; nothing without them.
  std::optional<std::uint16_t> line_port() const;
  /// The far end of the pseudo-terminal; empty without one.
  const std::string& terminal() const;

  void happened(const Event& event) override;
  void make_room() override;
  bool wanted() const noexcept override;
  void show(const Telemetry& telemetry) override;
  void show(Duration time, const Profile& profile) override;
  bool watched() const noexcept override;
  void show(std::shared_ptr<const SampleBlock> block) override;
  void show(std::vector<std::shared_ptr<const Rows>> rows) override;

  struct Parts;

 private:
  std::unique_ptr<Parts> parts_;
};

}  // namespace pal::server
