#include "programs/pal/session/patience.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "programs/pal/session/interruption.hpp"

namespace pal::program {
namespace {

/// What both threads know of the work.
struct Progress {
  std::mutex mutex;
  std::condition_variable done;
  bool ended = false;
  std::exception_ptr thrown;
};

bool work_left = false;

}  // namespace

bool done_in_patience(const std::function<void()>& work) {
  using namespace std::chrono_literals;
  using Clock = std::chrono::steady_clock;
  constexpr auto look = 10ms;
  constexpr auto patience = 20ms;
  const auto progress = std::make_shared<Progress>();
  std::thread([progress, work] {
    std::exception_ptr thrown;
    try {
      work();
    } catch (...) {
      thrown = std::current_exception();
    }
    const std::lock_guard lock(progress->mutex);
    progress->thrown = thrown;
    progress->ended = true;
    progress->done.notify_all();
  }).detach();
  std::optional<Clock::time_point> asked;
  std::unique_lock lock(progress->mutex);
  while (!progress->done.wait_for(lock, look, [&] { return progress->ended; })) {
    if (!Interruption::asked_for()) continue;
    if (!asked) asked = Clock::now();
    if (Clock::now() - *asked < patience) continue;
    leave_work();
    return false;
  }
  if (progress->thrown) std::rethrow_exception(progress->thrown);
  return true;
}

void leave_work() {
  work_left = true;
}

bool is_work_left() {
  return work_left;
}

}  // namespace pal::program
