#include "runtime/executives/scheduler.hpp"

#include <algorithm>

namespace pal::runtime {

using State = ThreadControl::State;

Scheduler::Scheduler(const Clock& clock, Journal& journal, EventQueue& queue, const Wiring& wiring)
    : clock_(clock), journal_(journal), queue_(queue) {
  for (const ProcessorSpec& spec : wiring.processors)
    processors_.emplace_back(spec, static_cast<int>(processors_.size()), wiring.threads.size());
  changed_.resize(processors_.size());
}

void Scheduler::note_change(Processor& processor) {
  if (processor.changed) return;
  processor.changed = true;
  changed_[changes_++] = &processor;
}

void Scheduler::enqueue(Processor& processor, Thread& thread) {
  ThreadControl& control = thread.control;
  control.state = State::ready;
  if (!control.announced) processor.arrived.push_back(&thread);
  processor.ready.add(thread);
}

void Scheduler::need_processor(Thread& thread, Time time) {
  ThreadControl& control = thread.control;
  Processor& processor = processor_of(thread);
  control.left = time;
  control.begun = false;
  note_change(processor);
  if (processor.running == &thread) return;  // keeps it from the statement before
  control.announced = false;
  control.queue_key = ++back_;
  enqueue(processor, thread);
}

void Scheduler::leave(Thread& thread) {
  Processor& processor = processor_of(thread);
  if (processor.running != &thread) {
    processor.ready.remove(thread);
    return;
  }
  if (processor.working) queue_.cancel(processor.end);
  processor.running = nullptr;
  processor.working = false;
  note_change(processor);
}

Thread& Scheduler::finish_work(int processor) {
  Processor& p = processors_[static_cast<std::size_t>(processor)];
  p.working = false;
  p.running->control.left = Time::zero();
  return *p.running;
}

void Scheduler::start(Processor& processor, Thread& thread) {
  ThreadControl& control = thread.control;
  control.state = State::running;
  control.begun = true;
  processor.running = &thread;
  processor.working = true;
  processor.since = clock_.now;
  journal_.record(trace::Kind::start, thread);
  processor.end = queue_.push(processor.since + control.left, Event::Kind::work_done, processor.index);
}

void Scheduler::start_first(Processor& processor) {
  start(processor, processor.ready.take_first());
}

void Scheduler::interrupt(Processor& processor) {
  Thread& thread = *processor.running;
  ThreadControl& control = thread.control;
  if (processor.working) {
    control.left -= clock_.now - processor.since;
    journal_.record(trace::Kind::stop, thread);
    control.announced = true;
    queue_.cancel(processor.end);
  } else {
    control.announced = false;  // between two statements
  }
  control.queue_key = --front_;
  processor.running = nullptr;
  processor.working = false;
  enqueue(processor, thread);
}

void Scheduler::dispatch(Processor& processor) {
  if (processor.ready.empty()) {  // the usual case
    processor.arrived.clear();
    if (processor.running != nullptr && !processor.working) start(processor, *processor.running);
    return;
  }
  if (processor.running == nullptr) {
    start_first(processor);
  } else if (processor.spec->preemptive &&
             processor.ready.first().control.spec->priority > processor.running->control.spec->priority) {
    interrupt(processor);
    start_first(processor);
  } else if (!processor.working) {
    start(processor, *processor.running);
  }
  if (processor.arrived.empty()) return;
  if (processor.ready.empty()) {
    processor.arrived.clear();
  } else {
    announce(processor);
  }
}

/// The trace learns which threads are ready without a processor, in the order of the threads.
void Scheduler::announce(Processor& processor) {
  std::vector<Thread*>& arrived = processor.arrived;
  if (arrived.size() > 1)
    std::sort(arrived.begin(), arrived.end(),
              [](const Thread* a, const Thread* b) { return a->control.index < b->control.index; });
  for (Thread* thread : arrived) {
    ThreadControl& control = thread->control;
    if (control.state != State::ready || control.announced) continue;
    control.announced = true;
    journal_.record(trace::Kind::ready, *thread);
  }
  arrived.clear();
}

void Scheduler::dispatch_all() {
  std::sort(changed_.begin(), changed_.begin() + static_cast<std::ptrdiff_t>(changes_),
            [](const Processor* a, const Processor* b) { return a->index < b->index; });
  for (std::size_t i = 0; i < changes_; ++i) {
    changed_[i]->changed = false;
    dispatch(*changed_[i]);
  }
  changes_ = 0;
}

void Scheduler::dispatch() {
  if (changes_ != 1) return dispatch_all();
  changes_ = 0;  // the usual case
  changed_.front()->changed = false;
  dispatch(*changed_.front());
}

}  // namespace pal::runtime
