// The coroutine type of module bodies and of the blocks of CONCURRENT.
#pragma once

#include <coroutine>
#include <cstddef>
#include <utility>

namespace pal::runtime {

class Thread;

namespace detail {
void* allocate_frame(Thread& thread, std::size_t size);
void release_frame(void* frame) noexcept;
void body_ended(Thread& thread) noexcept;
void body_threw(Thread& thread) noexcept;
}  // namespace detail

/// Owns a coroutine that follows one body of PAL, statement by statement. The coroutine is a function or a
/// member function. Its last parameter is the Thread that it runs in, and its frame comes from the thread's
/// pool. A body that Execute names is awaited: `co_await cm1.body(thread)` runs it in place of the caller.
class [[nodiscard]] Task {
 public:
  class promise_type {
   public:
    explicit promise_type(Thread& thread) : thread_(&thread) {}
    template <class Owner>
    promise_type(Owner&, Thread& thread) : thread_(&thread) {}

    // Inlined also without optimisation: g++ 12 takes a delete for a mismatch of a new that is a template.
    [[gnu::always_inline]] static void* operator new(std::size_t size, Thread& thread) {
      return detail::allocate_frame(thread, size);
    }
    template <class Owner>
    [[gnu::always_inline]] static void* operator new(std::size_t size, Owner&, Thread& thread) {
      return detail::allocate_frame(thread, size);
    }
    static void operator delete(void* frame, std::size_t) noexcept { detail::release_frame(frame); }

    struct Final {
      bool await_ready() const noexcept { return false; }
      std::coroutine_handle<> await_suspend(std::coroutine_handle<promise_type> body) const noexcept {
        promise_type& promise = body.promise();
        if (promise.caller_) return promise.caller_;
        detail::body_ended(*promise.thread_);
        return std::noop_coroutine();
      }
      void await_resume() const noexcept {}
    };

    Task get_return_object() { return Task(std::coroutine_handle<promise_type>::from_promise(*this)); }
    std::suspend_always initial_suspend() const noexcept { return {}; }
    Final final_suspend() const noexcept { return {}; }
    void return_void() const noexcept {}
    void unhandled_exception() const noexcept { detail::body_threw(*thread_); }

   private:
    friend class Task;
    Thread* thread_;
    std::coroutine_handle<> caller_;
  };

  Task() = default;
  Task(Task&& other) noexcept : body_(std::exchange(other.body_, {})) {}
  Task& operator=(Task&& other) noexcept {
    std::swap(body_, other.body_);
    return *this;
  }
  ~Task() { reset(); }

  explicit operator bool() const { return static_cast<bool>(body_); }
  std::coroutine_handle<> handle() const { return body_; }

  /// Destroys the coroutine where it stands.
  void reset() {
    if (body_) std::exchange(body_, {}).destroy();
  }

  struct Executed {
    std::coroutine_handle<promise_type> body;
    bool await_ready() const noexcept { return false; }
    std::coroutine_handle<> await_suspend(std::coroutine_handle<> caller) const noexcept {
      body.promise().caller_ = caller;
      return body;
    }
    void await_resume() const noexcept {}
  };
  Executed operator co_await() const noexcept { return {body_}; }

 private:
  explicit Task(std::coroutine_handle<promise_type> body) : body_(body) {}
  std::coroutine_handle<promise_type> body_;
};

}  // namespace pal::runtime
