#include "runtime/kernel/blocks.hpp"

#include <algorithm>

namespace pal::runtime {

using State = ThreadControl::State;

void Blocks::start(ConcurrentOperation& concurrent) {
  Thread& parent = concurrent.thread();
  parent.control.forked = &concurrent;
  flow_.block(parent, -1);
  for (const int block : concurrent.blocks()) {
    Thread& thread = this->thread(block);
    thread.control.parent = &parent;
    flow_.begin(thread);
  }
}

void Blocks::ended(Thread& thread) {
  thread.control.state = State::ended;
  thread.control.operation = nullptr;
  executive_.leave(thread);
  if (thread.control.parent == nullptr) return;
  mail_.hand_over(thread, *thread.control.parent);
  child_ended(*thread.control.parent);
}

void Blocks::child_ended(Thread& parent) {
  ThreadControl& control = parent.control;
  if (control.forked == nullptr) return;  // a stopped child was the last, see below
  const auto blocks = control.forked->blocks();
  const auto alive = [this](int block) { return this->thread(block).control.state != State::ended; };
  const bool goes_on = std::any_of(blocks.begin(), blocks.end(), [&](int block) {
    return alive(block) && this->thread(block).control.spec->can_end;
  });
  if (goes_on && !control.cancelled) return;
  for (const int block : blocks) {
    if (alive(block) && !this->thread(block).control.cancelled) cancel(this->thread(block));
  }
  if (control.forked == nullptr || std::any_of(blocks.begin(), blocks.end(), alive)) return;
  control.forked = nullptr;
  flow_.proceed(parent);
}

void Blocks::cancel(Thread& thread) {
  ThreadControl& control = thread.control;
  control.cancelled = true;
  if (control.forked != nullptr) {
    for (const int block : control.forked->blocks()) {
      Thread& child = this->thread(block);
      if (control.forked == nullptr) break;
      if (child.control.state != State::ended && !child.control.cancelled) cancel(child);
    }
    return;  // stops when its own blocks have
  }
  if (control.resuming) return;  // stops instead of going on
  if (control.state == State::blocked || !control.begun) stop(thread);
}

void Blocks::stop(Thread& thread) {
  ThreadControl& control = thread.control;
  journal_.record(trace::Kind::cancel, thread);
  mail_.abandon(thread);
  control.task.reset();
  ended(thread);
}

}  // namespace pal::runtime
