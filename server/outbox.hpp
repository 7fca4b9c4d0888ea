// What waits to be sent to one client. Answers and events are never left out; of telemetry the oldest is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>

namespace pal::server {

struct OutboxLimits {
  std::size_t most_bytes = std::size_t{16} << 20;  // of answers and events
  std::size_t most_samples = 64;                   // of telemetry
};

/// One thread only.
class Outbox {
 public:
  /// Makes the text of a sample when it is sent; `dropped`: samples left out before it, since the client
  /// came.
  using Sample = std::function<std::string(std::uint64_t dropped)>;

  explicit Outbox(OutboxLimits limits = {}) : limits_(limits) {}

  /// False: there is no room. The client has not read for so long that it must be let go, for nothing may be
  /// left out.
  bool put(std::string text);
  void put_sample(Sample sample);

  /// What is to be sent next: answers and events in their order, before telemetry. Nothing: it is empty.
  std::optional<std::string> take();

  /// So many samples were left out before they came here.
  void lose(std::uint64_t samples) { dropped_ += samples; }
  std::uint64_t dropped() const { return dropped_; }
  std::size_t bytes() const { return bytes_; }

 private:
  OutboxLimits limits_;
  std::deque<std::string> texts_;
  std::deque<Sample> samples_;
  std::size_t bytes_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace pal::server
