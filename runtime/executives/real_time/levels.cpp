#include "runtime/executives/real_time/levels.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

namespace pal::runtime {

using State = ThreadControl::State;

Levels::Levels(const Clock& clock, Journal& journal, const Wiring& wiring)
    : clock_(clock), journal_(journal) {
  for (const ProcessorSpec& spec : wiring.processors) processors_.emplace_back(spec, wiring.threads.size());
  std::map<std::pair<int, int>, Level*> known;  // by processor and priority
  for (const ThreadSpec& spec : wiring.threads) {
    const bool preemptive = wiring.processors[static_cast<std::size_t>(spec.processor)].preemptive;
    Level*& level = known[{spec.processor, preemptive ? spec.priority : 0}];
    if (level == nullptr) {
      level = &levels_.emplace_back();
      level->processor = spec.processor;
      level->priority = spec.priority;
    }
    level->priority = std::max(level->priority, spec.priority);
    level_of_.push_back(level);
  }
}

void Levels::enqueue(Processor& processor, Thread& thread) {
  ThreadControl& control = thread.control;
  control.state = State::ready;
  processor.ready.add(thread);
  if (!control.announced) processor.arrived.push_back(&thread);
}

void Levels::need_processor(Thread& thread) {
  ThreadControl& control = thread.control;
  Processor& processor = of(thread);
  control.begun = false;
  processor.changed = true;
  if (processor.running == &thread) return;  // keeps it from the statement before
  control.announced = false;
  control.queue_key = ++back_;
  enqueue(processor, thread);
}

void Levels::leave(Thread& thread) {
  level_of(thread).without_time = 0;
  Processor& processor = of(thread);
  if (processor.running != &thread) {
    processor.ready.remove(thread);
    return;
  }
  assert(!processor.working);
  processor.running = nullptr;
  processor.changed = true;
}

void Levels::finish(Level& level) {
  Processor& processor = of(*level.work);
  assert(processor.running == level.work && processor.working);
  processor.working = false;
  processor.changed = true;
  level.work = nullptr;
}

void Levels::interrupt(Processor& processor) {
  Thread& thread = *processor.running;
  if (processor.working) {
    journal_.record(trace::Kind::stop, thread);
    level_of(thread).since = clock_.now;
  }
  thread.control.announced = processor.working;
  thread.control.queue_key = --front_;
  processor.running = nullptr;
  processor.working = false;
  enqueue(processor, thread);
}

void Levels::start(Processor& processor, Thread& thread, std::vector<Doorbell*>& called) {
  thread.control.state = State::running;
  thread.control.begun = true;
  processor.running = &thread;
  processor.working = true;
  journal_.record(trace::Kind::start, thread);
  Level& level = level_of(thread);
  assert(level.work == nullptr || level.work == &thread);
  if (level.work == nullptr) {
    level.ticks = 0;
    level.interrupted = Time::zero();
  } else {
    level.interrupted += clock_.now - level.since;
  }
  level.work = &thread;
  if (processor.looks_out != nullptr && processor.looks_out != &level)
    processor.looks_out->aside.store(true, std::memory_order_relaxed);
  if (!std::exchange(level.waits, false)) return;
  called.push_back(&level.bell);
}

bool Levels::may_look_out(Level& level) {
  Processor& processor = processors_[static_cast<std::size_t>(level.processor)];
  if (processor.running != nullptr || !processor.ready.empty()) return false;
  const Level* other = processor.looks_out;
  if (other != nullptr && other != &level && !other->aside.load(std::memory_order_relaxed)) return false;
  level.aside.store(false, std::memory_order_relaxed);
  processor.looks_out = &level;
  return true;
}

void Levels::dispatch(Processor& processor, std::vector<Doorbell*>& called) {
  ReadyQueue& ready = processor.ready;
  if (processor.running == nullptr) {
    if (!ready.empty()) start(processor, ready.take_first(), called);
  } else if (processor.spec->preemptive && !ready.empty() &&
             ready.first().control.spec->priority > processor.running->control.spec->priority) {
    interrupt(processor);
    start(processor, ready.take_first(), called);
  } else if (!processor.working) {
    start(processor, *processor.running, called);
  }
  announce(processor);
}

/// The trace learns which threads are ready without a processor.
void Levels::announce(Processor& processor) {
  for (Thread* thread : processor.arrived) {
    ThreadControl& control = thread->control;
    if (control.state != State::ready || control.announced) continue;
    control.announced = true;
    journal_.record(trace::Kind::ready, *thread);
  }
  processor.arrived.clear();
}

void Levels::dispatch(std::vector<Doorbell*>& called) {
  for (Processor& processor : processors_) {
    if (!processor.changed) continue;
    processor.changed = false;
    dispatch(processor, called);
  }
}

bool Levels::idle() const {
  return std::all_of(processors_.begin(), processors_.end(),
                     [](const Processor& each) { return each.running == nullptr && each.ready.empty(); });
}

}  // namespace pal::runtime
