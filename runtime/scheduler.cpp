#include "runtime/scheduler.hpp"

#include "runtime/run.hpp"

namespace pal::runtime {

using State = ThreadControl::State;

Scheduler::Scheduler(Run& run, const Wiring& wiring) : run_(run) {
  for (const ProcessorSpec& spec : wiring.processors) {
    processors_.emplace_back();
    processors_.back().spec = &spec;
  }
}

void Scheduler::add(Thread& thread) {
  processor_of(thread).threads.push_back(&thread);
}

Processor& Scheduler::processor_of(const Thread& thread) {
  return processors_[static_cast<std::size_t>(thread.control.spec->processor)];
}

void Scheduler::need_processor(Thread& thread, Time time) {
  ThreadControl& control = thread.control;
  control.left = time;
  control.begun = false;
  if (processor_of(thread).running == &thread) return;  // keeps it from the statement before
  control.state = State::ready;
  control.announced = false;
  control.queue_key = ++back_;
}

void Scheduler::leave(Thread& thread) {
  Processor& processor = processor_of(thread);
  if (processor.running != &thread) return;
  processor.running = nullptr;
  processor.working = false;
  ++processor.token;
}

bool Scheduler::expects(int processor, std::uint64_t token) const {
  const Processor& p = processors_[static_cast<std::size_t>(processor)];
  return p.working && p.token == token;
}

Thread& Scheduler::finish_work(int processor) {
  Processor& p = processors_[static_cast<std::size_t>(processor)];
  p.working = false;
  p.running->control.left = Time::zero();
  return *p.running;
}

Thread* Scheduler::first_ready(const Processor& processor) const {
  Thread* first = nullptr;
  for (Thread* thread : processor.threads) {
    const ThreadControl& control = thread->control;
    if (control.state != State::ready) continue;
    const bool before = first == nullptr || control.spec->priority > first->control.spec->priority ||
                        (control.spec->priority == first->control.spec->priority &&
                         control.queue_key < first->control.queue_key);
    if (before) first = thread;
  }
  return first;
}

void Scheduler::start(Processor& processor, Thread& thread) {
  ThreadControl& control = thread.control;
  control.state = State::running;
  control.begun = true;
  processor.running = &thread;
  processor.working = true;
  processor.since = run_.now();
  ++processor.token;
  run_.record(trace::Kind::start, thread);
  run_.queue().push(run_.now() + control.left, Event::Kind::work_done, control.spec->processor,
                    processor.token);
}

void Scheduler::interrupt(Processor& processor) {
  Thread& thread = *processor.running;
  ThreadControl& control = thread.control;
  if (processor.working) {
    control.left -= run_.now() - processor.since;
    run_.record(trace::Kind::stop, thread);
    control.announced = true;
  } else {
    control.announced = false;  // between two statements
  }
  control.state = State::ready;
  control.queue_key = --front_;
  leave(thread);
}

void Scheduler::dispatch(Processor& processor) {
  Thread* next = first_ready(processor);
  if (processor.running != nullptr) {
    const bool preempts = processor.spec->preemptive && next != nullptr &&
                          next->control.spec->priority > processor.running->control.spec->priority;
    if (preempts) {
      interrupt(processor);
    } else {
      if (!processor.working) start(processor, *processor.running);
      next = nullptr;
    }
  }
  if (next != nullptr) start(processor, *next);
  for (Thread* thread : processor.threads) {
    ThreadControl& control = thread->control;
    if (control.state != State::ready || control.announced) continue;
    control.announced = true;
    run_.record(trace::Kind::ready, *thread);
  }
}

void Scheduler::dispatch() {
  for (Processor& processor : processors_) dispatch(processor);
}

}  // namespace pal::runtime
