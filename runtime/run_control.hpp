// What somebody outside may ask of a run while it goes on.
#pragma once

#include <atomic>

namespace pal::runtime {

/// Asked from another thread or from a signal handler; the run reads it before each event. Virtual and paced
/// runs alike.
class RunControl {
 public:
  /// Ends the skill with its error completion; devices are closed. Stays so: a skill that begins afterwards
  /// is refused.
  void stop() noexcept { stop_.store(true, std::memory_order_relaxed); }
  bool stopping() const noexcept { return stop_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> stop_ = false;
  static_assert(std::atomic<bool>::is_always_lock_free);
};

}  // namespace pal::runtime
