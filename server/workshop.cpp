#include "server/workshop.hpp"

#include <utility>

#include "server/urgency.hpp"

namespace pal::server {

Workshop::Workshop(bool thread) {
  if (thread) thread_ = std::thread([this] { work(); });
}

Workshop::~Workshop() {
  end();
}

void Workshop::end() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

Workshop::Ticket Workshop::submit(ClientId client, Job job) {
  auto unwanted = std::make_shared<std::atomic<bool>>(false);
  if (!thread_.joinable()) {
    job([unwanted] { return unwanted->load(); });
    return unwanted;
  }
  {
    const std::lock_guard lock(mutex_);
    std::size_t& count = count_[client];
    if (count >= most_waiting) return nullptr;
    ++count;
    waiting_.push_back({client, std::move(job), unwanted});
  }
  changed_.notify_all();
  return unwanted;
}

void Workshop::work() {
  work_beside();
  for (;;) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    Work next = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    next.job([this, unwanted = next.unwanted] { return unwanted->load() || ending_.load(); });
    lock.lock();
    if (--count_[next.client] == 0) count_.erase(next.client);
  }
}

}  // namespace pal::server
