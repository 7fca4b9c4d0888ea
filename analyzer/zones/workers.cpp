#include "analyzer/zones/workers.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace pal::analyzer {
namespace {

/// Tasks follow one another closely, and waking takes longer than many of them. So it polls for a while
/// before it returns false. Then the caller sleeps.
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
    : threads_(threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency())),
      shares_(threads_) {}

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
  call_helpers();
  {
    const std::lock_guard lock(mutex_);
    part_ = &part;
    grain_ = grain;
    for (std::size_t t = 0; t < threads_; ++t) {
      shares_[t].next = count * t / threads_;
      shares_[t].end = count * (t + 1) / threads_;
    }
    open_ = true;
    ++round_;
  }
  begin_.notify_all();
  work(0);
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

void Workers::call_helpers() {
  try {
    while (more_ && helpers_.size() + 1 < threads_)
      helpers_.emplace_back([this, self = helpers_.size() + 1] { help(self); });
  } catch (const std::system_error&) {
    more_ = false;
  }
}

void Workers::help(std::size_t self) {
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
    work(self);
    lock.lock();
    if (--active_ == 0) done_.notify_one();
  }
}

void Workers::work(std::size_t self) {
  try {
    for (std::size_t t = 0; t < threads_; ++t) take_from(shares_[(self + t) % threads_]);
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!thrown_) thrown_ = std::current_exception();
  }
}

void Workers::take_from(Share& share) {
  for (;;) {
    const std::size_t from = share.next.fetch_add(grain_);
    if (from >= share.end) return;
    for (std::size_t i = from; i < std::min(from + grain_, share.end); ++i) (*part_)(i);
  }
}

}  // namespace pal::analyzer
