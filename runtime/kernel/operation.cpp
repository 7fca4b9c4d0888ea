#include "pal/runtime/operation.hpp"

#include "runtime/kernel/kernel.hpp"

namespace pal::runtime {

using trace::Kind;

void Operation::await_suspend(std::coroutine_handle<> body) {
  ThreadControl& control = thread_.control;
  control.resume_point = body;
  control.operation = this;
  reach();
}

namespace {

/// The thread needs its processor for the statement of `operation`.
void need_processor(const Operation& operation) {
  Kernel& kernel = operation.thread().kernel();
  const auto statement = static_cast<std::size_t>(operation.statement());
  kernel.executive.need_processor(operation.thread(), kernel.wiring.statements[statement].cost);
}

void end_statement(Thread& thread) {
  thread.kernel().journal.record(Kind::done, thread);
  thread.kernel().flow.proceed(thread);
}

}  // namespace

void Step::reach() {
  need_processor(*this);
}

void Step::effect() {
  act();
  end_statement(thread());
}

void SetCondition::act() {
  thread().kernel().conditions.set(thread(), condition_, value_);
}

void Read::act() {
  thread().control.latched[static_cast<std::size_t>(condition_)] =
      thread().kernel().conditions.read(thread(), condition_);
}

void TestConditions::act() {
  ThreadControl& control = thread().control;
  for (const int condition : conditions()) {
    const auto c = static_cast<std::size_t>(condition);
    control.tested[c] =
        control.latched[c] ? *control.latched[c] : thread().kernel().conditions.read(thread(), condition);
  }
  for (auto& latch : control.latched) latch.reset();
}

void Complete::act() {
  thread().kernel().journal.complete(thread(), code_);
}

void TakeStart::reach() {
  end_statement(thread());
}

void NoArm::reach() {
  thread().kernel().journal.fail(thread(), "no arm holds");
}

void SendOperation::reach() {
  need_processor(*this);
}

void SendOperation::effect() {
  Kernel& kernel = thread().kernel();
  if (!kernel.mail.send(*this)) kernel.blocks.stop(thread());
}

void WaitOperation::reach() {
  thread().kernel().mail.reach(*this);
}

void WaitOperation::effect() {
  Kernel& kernel = thread().kernel();
  if (!kernel.mail.finish(*this)) kernel.blocks.stop(thread());
}

void ConcurrentOperation::reach() {
  thread().kernel().blocks.start(*this);
}

}  // namespace pal::runtime
