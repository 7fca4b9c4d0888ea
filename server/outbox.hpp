// What waits to be sent to one client. Answers and events are never left out; of live data the oldest is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace pal::server {

struct OutboxLimits {
  std::size_t most_bytes = std::size_t{16} << 20;  // of answers and events
  std::size_t most_samples = 256;                  // messages of live data
};

/// A message of live data, which is dropped if the client does not read.
struct LiveMessage {
  /// Makes the message when it is sent; `dropped`: samples left out before it, since the client came.
  std::function<std::string(std::uint64_t dropped)> make;
  bool binary = false;
  std::uint64_t samples = 1;  // that are in it
};

struct OutgoingMessage {
  std::string text;
  bool binary = false;
};

/// One thread only.
class Outbox {
 public:
  explicit Outbox(OutboxLimits limits = {}) : limits_(limits) {}

  /// False: there is no room. The client has not read for so long that it must be let go, for nothing may be
  /// left out.
  bool put(std::string text);
  void put_sample(LiveMessage message);

  /// What is to be sent next: answers and events in their order, before live data. Nothing: it is empty.
  std::optional<OutgoingMessage> take();

  /// So many samples were left out before they came here.
  void lose(std::uint64_t samples) { dropped_ += samples; }
  std::uint64_t dropped() const { return dropped_; }
  std::size_t bytes() const { return bytes_; }

 private:
  OutboxLimits limits_;
  std::deque<std::string> texts_;
  std::deque<LiveMessage> samples_;
  std::size_t bytes_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace pal::server
