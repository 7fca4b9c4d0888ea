#include "runtime/operation.hpp"

#include "runtime/run.hpp"

namespace pal::runtime {

using trace::Kind;

void Operation::await_suspend(std::coroutine_handle<> body) {
  ThreadControl& control = thread_.control;
  control.resume_point = body;
  control.operation = this;
  reach();
}

void Step::reach() {
  Run& run = thread().run();
  run.scheduler().need_processor(thread(), run.cost_of(statement()));
}

void Step::work_done() {
  Run& run = thread().run();
  effect();
  run.record(Kind::done, thread());
  run.proceed(thread());
}

void SetCondition::effect() {
  thread().run().set_condition(thread(), condition_, value());
}

void Read::effect() {
  thread().control.latched[static_cast<std::size_t>(condition_)] =
      thread().run().read_condition(thread(), condition_);
}

void TestConditions::effect() {
  ThreadControl& control = thread().control;
  for (const int condition : conditions()) {
    const auto c = static_cast<std::size_t>(condition);
    control.tested[c] =
        control.latched[c] ? *control.latched[c] : thread().run().read_condition(thread(), condition);
  }
  for (auto& latch : control.latched) latch.reset();
}

void Complete::effect() {
  thread().run().complete(thread(), code_);
}

void TakeStart::reach() {
  thread().run().record(Kind::done, thread());
  thread().run().proceed(thread());
}

void NoArm::reach() {
  thread().run().fail(thread(), "no arm holds");
}

void SendOperation::reach() {
  Run& run = thread().run();
  run.scheduler().need_processor(thread(), run.cost_of(statement()));
}

void SendOperation::work_done() {
  prepare();
  thread().run().mail().send(*this);
}

void WaitOperation::reach() {
  thread().run().mail().reach(*this);
}

void WaitOperation::work_done() {
  thread().run().mail().finish(*this);
}

void ConcurrentOperation::reach() {
  thread().run().blocks().start(*this);
}

}  // namespace pal::runtime
