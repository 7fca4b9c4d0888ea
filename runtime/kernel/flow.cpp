#include "runtime/kernel/flow.hpp"

namespace pal::runtime {

using State = ThreadControl::State;

Flow::Flow(Executive& executive, Journal& journal, Skill& skill)
    : executive_(executive), journal_(journal), skill_(skill) {
  set_going_.resize(skill.wiring().threads.size());
  resuming_.resize(skill.wiring().threads.size());
}

void Flow::begin(Thread& thread) {
  ThreadControl& control = thread.control;
  if (control.state != State::idle) {  // the coroutine of the last time is used up
    control.task.reset();
    control.task = skill_.body(static_cast<std::size_t>(control.index), thread);
  }
  control.state = State::blocked;
  control.cancelled = false;
  control.operation = nullptr;
  for (auto& latch : control.latched) latch.reset();
  control.resume_point = control.task.handle();
  proceed(thread);
}

void Flow::block(Thread& thread, int subject) {
  executive_.leave(thread);
  thread.control.state = State::blocked;
  journal_.record(trace::Kind::block, thread, subject);
}

}  // namespace pal::runtime
