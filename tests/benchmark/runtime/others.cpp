#include <condition_variable>
#include <coroutine>
#include <exception>
#include <mutex>
#include <thread>

#include "tests/benchmark/runtime/rows.hpp"

namespace pal::benchmark {
namespace {

/// A coroutine without a result, which its maker destroys.
struct Routine {
  struct promise_type {
    Routine get_return_object() { return {std::coroutine_handle<promise_type>::from_promise(*this)}; }
    std::suspend_always initial_suspend() const noexcept { return {}; }
    std::suspend_always final_suspend() const noexcept { return {}; }
    void return_void() const noexcept {}
    void unhandled_exception() const noexcept { std::terminate(); }
  };
  std::coroutine_handle<promise_type> handle;
};

struct Transfer {
  std::coroutine_handle<> to;
  bool await_ready() const noexcept { return false; }
  std::coroutine_handle<> await_suspend(std::coroutine_handle<>) const noexcept { return to; }
  void await_resume() const noexcept {}
};

Routine partner(std::size_t count, const std::coroutine_handle<>& other) {
  for (std::size_t i = 0; i < count; ++i) co_await Transfer{other};
}

}  // namespace

void bare_transfers(std::size_t count) {
  std::coroutine_handle<> first, second;
  const Routine client = partner(count, second);
  const Routine server = partner(count + 1, first);
  first = client.handle;
  second = server.handle;
  first.resume();
  client.handle.destroy();
  server.handle.destroy();
}

void thread_round_trips(std::size_t count) {
  std::mutex mutex;
  std::condition_variable changed;
  bool asked = false;
  std::thread server([&] {
    std::unique_lock lock(mutex);
    for (std::size_t i = 0; i < count; ++i) {
      changed.wait(lock, [&] { return asked; });
      asked = false;
      changed.notify_one();
    }
  });
  {
    std::unique_lock lock(mutex);
    for (std::size_t i = 0; i < count; ++i) {
      asked = true;
      changed.notify_one();
      changed.wait(lock, [&] { return !asked; });
    }
  }
  server.join();
}

}  // namespace pal::benchmark
