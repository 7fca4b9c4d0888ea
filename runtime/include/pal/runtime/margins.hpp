// How near a run has come to its requirements, for another thread to read while it goes on.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "pal/runtime/device.hpp"

namespace pal::runtime {

/// One place for each requirement of the wiring, in its order. Written by the run, read by any thread.
class Margins {
 public:
  explicit Margins(std::size_t requirements)
      : size_(requirements), seen_(std::make_unique<Seen[]>(requirements)) {}

  std::size_t size() const { return size_; }
  /// The longest value of the requirement that was seen; the shortest, of one that has a limit only from
  /// below; of a load that of the run so far. Nothing: none was seen. The units are those of the
  /// requirement's limit.
  std::optional<Time> worst(std::size_t requirement) const { return read(seen_[requirement].worst); }
  /// The value that was seen last; in the same unit.
  std::optional<Time> latest(std::size_t requirement) const { return read(seen_[requirement].latest); }
  void set(std::size_t requirement, Time worst, Time latest) {
    seen_[requirement].worst.store(worst.count(), std::memory_order_relaxed);
    seen_[requirement].latest.store(latest.count(), std::memory_order_relaxed);
  }

 private:
  static constexpr std::int64_t nothing = INT64_MIN;
  struct Seen {
    std::atomic<std::int64_t> worst = nothing, latest = nothing;
  };
  static std::optional<Time> read(const std::atomic<std::int64_t>& seen) {
    const std::int64_t value = seen.load(std::memory_order_relaxed);
    return value == nothing ? std::nullopt : std::optional(Time(value));
  }
  std::size_t size_;
  std::unique_ptr<Seen[]> seen_;
};

}  // namespace pal::runtime
