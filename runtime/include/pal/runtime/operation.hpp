// One statement that a thread has come to: what the coroutine of a body awaits.
//
// reach() is called when the thread comes to the statement, compute() while it has its processor, effect()
// when that time is over. None resumes the coroutine: Flow::proceed() does, when the effect of the statement
// has taken place.
#pragma once

#include <array>
#include <coroutine>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "pal/runtime/wiring.hpp"

namespace pal::runtime {

class Thread;

class Operation {
 public:
  Operation(Thread& thread, int statement) : thread_(thread), statement_(statement) {}
  Operation(const Operation&) = delete;
  Operation& operator=(const Operation&) = delete;

  Thread& thread() const { return thread_; }
  int statement() const { return statement_; }

  virtual void reach() = 0;
  /// The hand-written code. In real time other threads of the skill go on meanwhile.
  virtual void compute() {}
  /// Whether compute() runs such code.
  virtual bool by_hand() const { return false; }
  /// Its time is that of an activity; else it is a COST of the environment.
  virtual bool is_activity() const { return false; }
  virtual void effect() = 0;

  bool await_ready() const noexcept { return false; }
  void await_suspend(std::coroutine_handle<> body);
  void await_resume() const noexcept {}

 protected:
  ~Operation() = default;

 private:
  Thread& thread_;
  int statement_;
};

/// Takes its processor time and then has its effect.
class Step : public Operation {
 public:
  using Operation::Operation;
  void reach() final;
  void effect() final;

 protected:
  ~Step() = default;
  virtual void act() = 0;
};

/// An activity, written by hand.
template <class Work>
class Perform final : public Step {
 public:
  Perform(Thread& thread, int statement, Work work) : Step(thread, statement), work_(std::move(work)) {}
  void compute() override { work_(); }
  bool by_hand() const override { return true; }
  bool is_activity() const override { return true; }

 private:
  void act() override {}
  Work work_;
};

/// SPC.
class SetCondition : public Step {
 public:
  SetCondition(Thread& thread, int statement, int condition)
      : Step(thread, statement), condition_(condition) {}
  void compute() final { value_ = value(); }
  bool by_hand() const override { return true; }

 protected:
  ~SetCondition() = default;
  virtual bool value() = 0;

 private:
  void act() final;
  int condition_;
  bool value_ = false;
};

template <class Decision>
class Set final : public SetCondition {
 public:
  Set(Thread& thread, int statement, int condition, Decision decide)
      : SetCondition(thread, statement, condition), decide_(std::move(decide)) {}

 private:
  bool value() override { return decide_(); }
  Decision decide_;
};

/// RPC.
class Read final : public Step {
 public:
  Read(Thread& thread, int statement, int condition) : Step(thread, statement), condition_(condition) {}

 private:
  void act() override;
  int condition_;
};

/// The test of a CASE or an UNTIL: Thread::tested() then gives the values that were seen.
class TestConditions : public Step {
 public:
  using Step::Step;

 protected:
  ~TestConditions() = default;
  virtual std::span<const int> conditions() const = 0;

 private:
  void act() final;
};

template <std::size_t count>
class Test final : public TestConditions {
 public:
  Test(Thread& thread, int statement, std::array<int, count> conditions)
      : TestConditions(thread, statement), conditions_(conditions) {}

 private:
  std::span<const int> conditions() const override { return conditions_; }
  std::array<int, count> conditions_;
};

/// TXM( Completion Protocol n ).
class Complete final : public Step {
 public:
  Complete(Thread& thread, int statement, int code) : Step(thread, statement), code_(code) {}

 private:
  void act() override;
  int code_;
};

/// WTM( Coordinator ): the start was there at time 0.
class TakeStart final : public Operation {
 public:
  using Operation::Operation;
  void reach() override;
  void effect() override {}
};

/// A CASE without an arm that holds: ends the skill.
class NoArm final : public Operation {
 public:
  using Operation::Operation;
  void reach() override;
  void effect() override {}
};

/// TXM. The payload is fixed when the processor time is over, even if the slot is not free then.
class SendOperation : public Operation {
 public:
  SendOperation(Thread& thread, int statement, int channel)
      : Operation(thread, statement), channel_(channel) {}

  int channel() const { return channel_; }
  virtual std::span<const double> payload() const = 0;

  void reach() final;
  void compute() final { prepare(); }
  void effect() final;

 protected:
  ~SendOperation() = default;
  virtual void prepare() = 0;

 private:
  int channel_;
};

class SendSignal final : public SendOperation {
 public:
  using SendOperation::SendOperation;
  std::span<const double> payload() const override { return {}; }

 private:
  void prepare() override {}
};

template <class Message, class Compose>
class Send final : public SendOperation {
 public:
  Send(Thread& thread, int statement, int channel, const Message& message, Compose compose)
      : SendOperation(thread, statement, channel), message_(message), compose_(std::move(compose)) {}
  std::span<const double> payload() const override { return fields_; }
  bool by_hand() const override { return true; }

 private:
  void prepare() override {
    compose_();
    fields_ = message_.fields();
  }
  const Message& message_;
  Compose compose_;
  std::array<double, Message::field_count> fields_{};
};

/// A channel that a WTM takes from, and where the message goes.
struct Target {
  int channel = -1;
  void* message = nullptr;
  void (*store)(void* message, std::span<const double> fields) = nullptr;
};

/// A message without fields, or one whose fields the module has no use for.
inline Target from(int channel) {
  return {channel, nullptr, nullptr};
}

/// A message that becomes the module's `message`.
template <class Message>
Target from(int channel, Message& message) {
  return {channel, &message, [](void* into, std::span<const double> fields) {
            *static_cast<Message*>(into) = Message::from_fields(fields);
          }};
}

/// WTM in all its forms. Awaiting gives the index of the target that a message was taken for, or -1: gave up.
class WaitOperation : public Operation {
 public:
  /// `targets` outlive the wait.
  WaitOperation(Thread& thread, int statement, std::optional<Time> within, std::span<const Target> targets)
      : Operation(thread, statement), within_(within), targets_(targets) {}

  std::span<const Target> targets() const { return targets_; }
  const std::optional<Time>& within() const { return within_; }

  void reach() final;
  void effect() final;
  int await_resume() const noexcept { return chosen; }

  // The run's notes about this wait.
  Time deadline{};
  int chosen = -1;

 protected:
  ~WaitOperation() = default;

 private:
  std::optional<Time> within_;
  std::span<const Target> targets_;
};

template <std::size_t count>
class Wait final : public WaitOperation {
 public:
  Wait(Thread& thread, int statement, std::optional<Time> within, std::array<Target, count> targets)
      : WaitOperation(thread, statement, within, targets_), targets_(targets) {}

 private:
  std::array<Target, count> targets_;
};

/// CONCURRENT: the coroutine goes on when every block has ended or was stopped.
class ConcurrentOperation : public Operation {
 public:
  using Operation::Operation;
  virtual std::span<const int> blocks() const = 0;

  void reach() final;
  void effect() final {}

 protected:
  ~ConcurrentOperation() = default;
};

template <std::size_t count>
class Concurrent final : public ConcurrentOperation {
 public:
  Concurrent(Thread& thread, int statement, std::array<int, count> blocks)
      : ConcurrentOperation(thread, statement), blocks_(blocks) {}
  std::span<const int> blocks() const override { return blocks_; }

 private:
  std::array<int, count> blocks_;
};

}  // namespace pal::runtime
