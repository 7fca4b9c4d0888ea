#include "pal/runtime/run_control.hpp"

#include <algorithm>
#include <utility>

namespace pal::runtime {
namespace {

// A signal handler cannot wake a thread that waits.
constexpr std::chrono::milliseconds look_each(20);

}  // namespace

// With the mutex.
void RunControl::watch() {
  if (!refusal_.empty()) {
    paused_ = false;
    steps_ = 0;
    breakpoints_.clear();
  }
  const bool any = paused_ || steps_ > 0 || stop_at_ != Time::max() || !breakpoints_.empty();
  if (any) {
    asked_.fetch_or(watch_bit, std::memory_order_relaxed);
  } else {
    asked_.fetch_and(~watch_bit, std::memory_order_relaxed);
  }
  changed_.notify_all();
}

std::string RunControl::refusal() const {
  const std::lock_guard lock(mutex_);
  return refusal_;
}

void RunControl::refuse_to_hold(std::string why) {
  const std::lock_guard lock(mutex_);
  refusal_ = std::move(why);
  watch();
}

void RunControl::stop_at(Time when) {
  const std::lock_guard lock(mutex_);
  stop_at_ = when;
  watch();
}

void RunControl::pause() {
  const std::lock_guard lock(mutex_);
  paused_ = true;
  stepped_ = false;
  watch();
}

void RunControl::resume() {
  const std::lock_guard lock(mutex_);
  paused_ = false;
  steps_ = 0;
  watch();
}

void RunControl::step(std::size_t statements) {
  const std::lock_guard lock(mutex_);
  paused_ = false;
  steps_ = std::max<std::size_t>(statements, 1);
  watch();
}

void RunControl::break_at(std::string where, int line) {
  const std::lock_guard lock(mutex_);
  breakpoints_.push_back({std::move(where), line});
  watch();
}

void RunControl::clear_breakpoints() {
  const std::lock_guard lock(mutex_);
  breakpoints_.clear();
  watch();
}

std::optional<Halt> RunControl::wait_for_halt(std::chrono::milliseconds limit) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, limit, [this] { return halt_ && paused_; });
  return paused_ ? halt_ : std::nullopt;
}

Time RunControl::stop_instant() const {
  const std::lock_guard lock(mutex_);
  return stop_at_;
}

void RunControl::count_statement() {
  const std::lock_guard lock(mutex_);
  if (steps_ == 0 || --steps_ > 0) return;
  paused_ = stepped_ = true;
}

std::string RunControl::reason_to_hold(std::uint64_t event, std::string_view module, std::string_view file,
                                       int line) {
  const std::lock_guard lock(mutex_);
  const bool again = std::exchange(held_before_, event) == event;
  if (paused_) return stepped_ ? "stepped" : "paused";
  if (line == 0 || again) return {};
  const std::string_view name = file.substr(file.rfind('/') + 1);
  for (const Breakpoint& each : breakpoints_) {
    if (each.line != line || (each.where != module && each.where != file && each.where != name)) continue;
    paused_ = true;
    steps_ = 0;
    return "breakpoint at " + each.where + ":" + std::to_string(line);
  }
  return {};
}

void RunControl::hold(Halt halt) {
  std::unique_lock lock(mutex_);
  halt_ = std::move(halt);
  changed_.notify_all();
  while (paused_ && !stopping()) changed_.wait_for(lock, look_each);
  halt_.reset();
  stepped_ = false;
}

}  // namespace pal::runtime
