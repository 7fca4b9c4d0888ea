// Carries events of a run to an observer: a file's writer, a viewer.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pal/runtime/wiring.hpp"
#include "pal/trace/trace.hpp"

namespace pal::runtime {

/// One run puts events in, and one other thread takes them out; neither ever waits for the other. Events that
/// find the ring full are dropped and counted. All memory is allocated at the beginning.
class TraceRing {
 public:
  /// Room for `capacity` events, from 1 on, rounded up to a power of two.
  explicit TraceRing(std::size_t capacity);

  std::size_t capacity() const { return events_.size(); }

  /// The run's side.
  void put(const trace::Event& event) noexcept {
    const std::uint64_t at = put_.load(std::memory_order_relaxed);
    if (at - taken_.load(std::memory_order_acquire) == events_.size()) {
      dropped_.store(dropped_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
      return;
    }
    events_[at & mask_] = event;
    put_.store(at + 1, std::memory_order_release);
  }

  /// The other side: takes the oldest events into `room`, returns how many.
  std::size_t take(std::span<trace::Event> room) noexcept;

  /// How many were dropped up to now. From any thread.
  std::uint64_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }

 private:
  std::vector<trace::Event> events_;
  std::uint64_t mask_;
  // Apart, so that the two threads do not take a line of the cache from each other.
  alignas(64) std::atomic<std::uint64_t> put_ = 0;
  std::atomic<std::uint64_t> dropped_ = 0;
  alignas(64) std::atomic<std::uint64_t> taken_ = 0;
};

/// The tables that the events of a skill's runs index, and no event.
trace::Trace trace_tables(const Wiring& wiring);

}  // namespace pal::runtime
