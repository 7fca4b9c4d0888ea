#include "analyzer/runs/interrupter.hpp"

#include <chrono>
#include <utility>

namespace pal::analyzer {

Interrupter::Interrupter(std::function<bool()> stop, std::function<void()> interrupt)
    : stop_(std::move(stop)), interrupt_(std::move(interrupt)) {
  if (stop_) thread_ = std::thread([this] { watch(); });
}

Interrupter::~Interrupter() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  end_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void Interrupter::watch() {
  std::unique_lock lock(mutex_);
  while (!end_.wait_for(lock, std::chrono::milliseconds(20), [this] { return ended_; })) {
    if (!stop_()) continue;
    interrupted_ = true;
    interrupt_();
  }
}

}  // namespace pal::analyzer
