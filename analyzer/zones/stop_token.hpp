// Cooperative cancellation for several threads.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>

namespace pal::analyzer {

/// Like std::stop_token, for a stop that has to be polled: signals, deadlines.
class StopToken {
 public:
  /// `stop`, if given, is called by one thread at a time, and no more once it has returned true.
  explicit StopToken(const std::function<bool()>& stop) : stop_(stop) {}

  bool stop_requested() {
    if (requested_ || !stop_) return requested_;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock.owns_lock() && !requested_ && stop_()) requested_ = true;
    return requested_;
  }

 private:
  const std::function<bool()>& stop_;
  std::mutex mutex_;
  std::atomic<bool> requested_ = false;
};

}  // namespace pal::analyzer
