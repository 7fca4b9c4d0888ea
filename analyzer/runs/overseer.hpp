// Ends what somebody else's code is at.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace pal::analyzer {

/// For a solver that knows nothing of signals and deadlines. While it lives, a thread of its own asks `stop`
/// fifty times a second, and calls `interrupt` each time that it says true; nobody else may ask `stop`
/// meanwhile. Without a `stop` it does nothing.
class Overseer {
 public:
  Overseer(std::function<bool()> stop, std::function<void()> interrupt);
  ~Overseer();
  Overseer(const Overseer&) = delete;
  Overseer& operator=(const Overseer&) = delete;

  /// `interrupt` was called.
  bool interrupted() const { return interrupted_; }

 private:
  void oversee();

  const std::function<bool()> stop_;
  const std::function<void()> interrupt_;
  std::mutex mutex_;
  std::condition_variable end_;
  bool ended_ = false;
  std::atomic<bool> interrupted_ = false;
  std::thread thread_;
};

}  // namespace pal::analyzer
