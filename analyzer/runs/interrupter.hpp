// Interrupts a solver from another thread once it has to stop.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace pal::analyzer {

/// For a solver that cannot check signals and deadlines itself. While this object lives, a thread of its own
/// calls `stop` fifty times a second, and calls `interrupt` each time that it returns true. No other
/// thread may call `stop` meanwhile. Without a `stop` it does nothing.
class Interrupter {
 public:
  Interrupter(std::function<bool()> stop, std::function<void()> interrupt);
  ~Interrupter();
  Interrupter(const Interrupter&) = delete;
  Interrupter& operator=(const Interrupter&) = delete;

  /// `interrupt` was called.
  bool interrupted() const { return interrupted_; }

 private:
  void watch();

  const std::function<bool()> stop_;
  const std::function<void()> interrupt_;
  std::mutex mutex_;
  std::condition_variable end_;
  bool ended_ = false;
  std::atomic<bool> interrupted_ = false;
  std::thread thread_;
};

}  // namespace pal::analyzer
