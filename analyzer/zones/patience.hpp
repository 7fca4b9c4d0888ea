// Whether it is time to stop, for several threads.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>

namespace pal::analyzer {

class Patience {
 public:
  /// `stop`, if given, is asked by one thread at a time, and no more once it has said true.
  explicit Patience(const std::function<bool()>& stop) : stop_(stop) {}

  bool over() {
    if (over_ || !stop_) return over_;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock.owns_lock() && !over_ && stop_()) over_ = true;
    return over_;
  }

 private:
  const std::function<bool()>& stop_;
  std::mutex mutex_;
  std::atomic<bool> over_ = false;
};

}  // namespace pal::analyzer
