// A thread of a skill, as generated code uses it.
#pragma once

#include <array>
#include <coroutine>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "pal/runtime/executive.hpp"
#include "pal/runtime/operation.hpp"
#include "pal/runtime/task.hpp"
#include "pal/runtime/wiring.hpp"

namespace pal::runtime {

class Kernel;

/// What the kernel knows about a thread.
struct ThreadControl {
  enum class State { idle, blocked, ready, running, ended };

  int index = 0;
  const ThreadSpec* spec = nullptr;
  State state = State::idle;

  Task task;
  std::coroutine_handle<> resume_point;
  Operation* operation = nullptr;  // the statement that the thread has come to
  bool resuming = false;           // its effect has taken place; the coroutine is about to go on

  // On the processor.
  Time left{};                  // processor time that the statement still needs
  bool begun = false;           // some of it was given
  bool announced = false;       // the trace knows that the thread is ready
  std::int64_t queue_key = 0;   // among equals the least goes first
  std::size_t ready_place = 0;  // where it is among those that wait for its processor

  // Without a processor; each is set while it is true.
  WaitOperation* waiting = nullptr;
  SendOperation* sending = nullptr;
  ConcurrentOperation* forked = nullptr;
  std::size_t blocks_alive = 0;   // of `forked`: how many have not ended
  std::size_t blocks_ending = 0;  // how many of these can end
  bool blocks_told = false;       // those that have not ended were told to stop
  Ticket expiry;                  // when the wait gives up
  int claimed = -1;               // the channel whose message it has begun to receive

  // A block of CONCURRENT.
  Thread* parent = nullptr;
  bool cancelled = false;

  // Conditions, one entry each.
  std::vector<std::optional<bool>> latched;
  std::vector<bool> tested;
};

/// Statements, channels, conditions and blocks are named by their index in the wiring. Each of these
/// functions is one statement of PAL, to be awaited at once: `co_await thread.send(…)`. Their arguments must
/// outlive the statement.
class Thread {
 public:
  Thread(Kernel& kernel, int index, const ThreadSpec& spec, std::size_t conditions);
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;

  auto take_start(int statement) { return TakeStart(*this, statement); }

  /// `work()` runs at the effect.
  template <class Work>
  auto perform(int statement, Work work) {
    return Perform<Work>(*this, statement, std::move(work));
  }

  /// The condition becomes what `decide()` returns at the effect.
  template <class Decision>
  auto set(int statement, int condition, Decision decide) {
    return Set<Decision>(*this, statement, condition, std::move(decide));
  }
  auto set(int statement, int condition, bool value) {
    return set(statement, condition, [value] { return value; });
  }

  auto read(int statement, int condition) { return Read(*this, statement, condition); }

  template <class... Condition>
  auto test(int statement, Condition... conditions) {
    return Test<sizeof...(conditions)>(*this, statement, {conditions...});
  }
  /// The value of `condition` in this thread's last test, which must have named it.
  bool tested(int condition) const { return control.tested[static_cast<std::size_t>(condition)]; }

  auto no_arm_holds(int statement) { return NoArm(*this, statement); }

  auto send(int statement, int channel) { return SendSignal(*this, statement, channel); }
  template <class Message>
  auto send(int statement, int channel, const Message& message) {
    return send(statement, channel, message, [] {});
  }
  /// `compose()`, run when the processor time is over, fills `message`.
  template <class Message, class Compose>
  auto send(int statement, int channel, const Message& message, Compose compose) {
    return Send<Message, Compose>(*this, statement, channel, message, std::move(compose));
  }

  template <class... Targets>
  auto wait(int statement, Targets... targets) {
    return Wait<sizeof...(targets)>(*this, statement, std::nullopt, {targets...});
  }
  template <class... Targets>
  auto wait_within(int statement, Time within, Targets... targets) {
    return Wait<sizeof...(targets)>(*this, statement, within, {targets...});
  }

  template <class... Block>
  auto concurrent(int statement, Block... blocks) {
    return Concurrent<sizeof...(blocks)>(*this, statement, {blocks...});
  }

  auto complete(int statement, int code) { return Complete(*this, statement, code); }

  /// While it lives the thread is in loop `loop`, which a phase of a requirement names.
  class Within {
   public:
    Within(Thread& thread, int loop);
    Within(const Within&) = delete;
    Within& operator=(const Within&) = delete;
    ~Within();

   private:
    Thread& thread_;
    int loop_;
  };
  Within within(int loop) { return Within(*this, loop); }

  /// In the wiring.
  int index() const { return control.index; }

  /// Where its statements find what they act on.
  Kernel& kernel() const { return kernel_; }

  ThreadControl control;

 private:
  Kernel& kernel_;
};

}  // namespace pal::runtime
