// Threads that share one task after another.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace pal::analyzer {

/// The work must not depend on which thread does which part, so that results do not depend on the number of
/// threads.
class Workers {
 public:
  /// `threads` work, the caller included; 0: one for each core. They start when they are needed. If the
  /// system gives no more threads, the existing ones do the work.
  explicit Workers(unsigned threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Calls part(0) … part(count - 1), in any order and at the same time, and returns when all have returned.
  /// Throws what one of them threw. `grain`: how many neighbours are given out at once. Each thread begins
  /// with its own share. It is the same in rounds of the same count, so its data are still in the cache. Then
  /// it helps with the shares of others. If a thread has no core, the others do its share; the round waits
  /// for it only if it has begun some parts.
  void each(std::size_t count, std::size_t grain, const std::function<void(std::size_t)>& part);

 private:
  /// A part of the round, in memory of its own.
  struct alignas(64) Share {
    std::atomic<std::size_t> next = 0;
    std::size_t end = 0;
  };

  void call_helpers();
  void help(std::size_t self);
  void work(std::size_t self);
  void take_from(Share& share);

  const unsigned threads_;
  bool more_ = true;  // helpers can be had
  std::mutex mutex_;
  std::condition_variable begin_;
  std::condition_variable done_;
  // Changed under the mutex, and looked at without it now and then.
  std::atomic<std::size_t> round_ = 0;
  std::atomic<bool> open_ = false;       // helpers may join the round
  std::atomic<std::size_t> active_ = 0;  // helpers that have, and are not done
  std::atomic<bool> end_ = false;
  std::exception_ptr thrown_;

  const std::function<void(std::size_t)>* part_ = nullptr;
  std::size_t grain_ = 1;
  std::vector<Share> shares_;  // by thread
  std::vector<std::thread> helpers_;
};

}  // namespace pal::analyzer
