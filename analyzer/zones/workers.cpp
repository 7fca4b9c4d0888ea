#include "analyzer/zones/workers.hpp"

#include <algorithm>
#include <utility>

namespace pal::analyzer {
namespace {

/// Tasks follow one another closely, and being woken takes longer than many of them: looks again for a while
/// before it says false, and then the caller sleeps.
template <class Condition>
bool soon(const Condition& condition) {
  for (int look = 0; look < 5000; ++look) {
    if (condition()) return true;
    std::this_thread::yield();
  }
  return false;
}

}  // namespace

Workers::Workers(unsigned threads)
    : threads_(threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency())) {}

Workers::~Workers() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  begin_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void Workers::each(std::size_t count, std::size_t grain, const std::function<void(std::size_t)>& part) {
  // What one thread can do at a stroke is not worth waking the others.
  if (threads_ == 1 || count <= grain) {
    for (std::size_t i = 0; i < count; ++i) part(i);
    return;
  }
  while (helpers_.size() + 1 < threads_) helpers_.emplace_back([this] { help(); });
  {
    const std::lock_guard lock(mutex_);
    part_ = &part;
    count_ = count;
    grain_ = grain;
    next_ = 0;
    open_ = true;
    ++round_;
  }
  begin_.notify_all();
  work();
  std::unique_lock lock(mutex_);
  open_ = false;
  if (active_ != 0) {
    lock.unlock();
    soon([this] { return active_ == 0; });
    lock.lock();
    done_.wait(lock, [this] { return active_ == 0; });
  }
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Workers::help() {
  std::size_t seen = 0;
  for (;;) {
    const auto called = [&] { return end_ || (open_ && round_ != seen); };
    soon(called);
    std::unique_lock lock(mutex_);
    begin_.wait(lock, called);
    if (end_) return;
    seen = round_;
    ++active_;
    lock.unlock();
    work();
    lock.lock();
    if (--active_ == 0) done_.notify_one();
  }
}

void Workers::work() {
  try {
    for (;;) {
      const std::size_t from = next_.fetch_add(grain_);
      if (from >= count_) return;
      for (std::size_t i = from; i < std::min(from + grain_, count_); ++i) (*part_)(i);
    }
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!thrown_) thrown_ = std::current_exception();
  }
}

}  // namespace pal::analyzer
