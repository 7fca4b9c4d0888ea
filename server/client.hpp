// A client of the WebSocket, for programs and tests.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace pal::server {

/// What the server answered instead of a result.
class RemoteError : public std::runtime_error {
 public:
  RemoteError(int code, const std::string& message) : std::runtime_error(message), code_(code) {}
  int code() const { return code_; }

 private:
  int code_;
};

/// One thread only. Each throws std::runtime_error when the connection breaks.
class Client {
 public:
  /// `origin`: as a browser would send it; empty: none.
  Client(const std::string& address, std::uint16_t port, const std::string& origin = {});
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// The result, as JSON text; `parameters` is an object in JSON. Throws RemoteError.
  std::string call(const std::string& method, const std::string& parameters = "{}");
  /// The next notification, as JSON text; nothing if none comes within this time.
  std::optional<std::string> next(std::chrono::milliseconds longest);

  // Without the rules of JSON-RPC: for tests.
  void send(const std::string& message);
  std::optional<std::string> receive(std::chrono::milliseconds longest);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pal::server
