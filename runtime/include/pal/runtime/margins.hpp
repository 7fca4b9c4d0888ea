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
      : size_(requirements), worst_(std::make_unique<std::atomic<std::int64_t>[]>(requirements)) {
    for (std::size_t i = 0; i < size_; ++i) worst_[i].store(nothing, std::memory_order_relaxed);
  }

  std::size_t size() const { return size_; }
  /// The longest value of the requirement that was seen; the shortest, of one that has a limit only from
  /// below; of a load that of the run so far. Nothing: none was seen. The units are those of the
  /// requirement's limit.
  std::optional<Time> worst(std::size_t requirement) const {
    const std::int64_t value = worst_[requirement].load(std::memory_order_relaxed);
    return value == nothing ? std::nullopt : std::optional(Time(value));
  }
  void set(std::size_t requirement, Time value) {
    worst_[requirement].store(value.count(), std::memory_order_relaxed);
  }

 private:
  static constexpr std::int64_t nothing = INT64_MIN;
  std::size_t size_;
  std::unique_ptr<std::atomic<std::int64_t>[]> worst_;
};

}  // namespace pal::runtime
