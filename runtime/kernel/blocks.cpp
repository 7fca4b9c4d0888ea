#include "runtime/kernel/blocks.hpp"

#include <utility>

namespace pal::runtime {

using State = ThreadControl::State;

void Blocks::start(ConcurrentOperation& concurrent) {
  Thread& parent = concurrent.thread();
  parent.control.forked = &concurrent;
  flow_.block(parent, -1);
  parent.control.blocks_alive = concurrent.blocks().size();
  parent.control.blocks_ending = 0;
  parent.control.blocks_told = false;
  for (const int block : concurrent.blocks()) {
    Thread& thread = this->thread(block);
    thread.control.parent = &parent;
    if (thread.control.spec->can_end) ++parent.control.blocks_ending;
    flow_.begin(thread);
  }
}

void Blocks::ended(Thread& thread) {
  thread.control.state = State::ended;
  thread.control.operation = nullptr;
  executive_.leave(thread);
  if (thread.control.parent == nullptr) return;
  Thread& parent = *thread.control.parent;
  mail_.hand_over(thread, parent);
  --parent.control.blocks_alive;
  if (thread.control.spec->can_end) --parent.control.blocks_ending;
  child_ended(parent);
}

void Blocks::child_ended(Thread& parent) {
  ThreadControl& control = parent.control;
  if (control.forked == nullptr) return;  // a stopped child was the last, see below
  if (control.blocks_ending > 0 && !control.cancelled) return;
  if (!std::exchange(control.blocks_told, true)) {
    for (const int block : control.forked->blocks()) {
      Thread& each = thread(block);
      if (each.control.state != State::ended && !each.control.cancelled) cancel(each);
    }
  }
  if (control.forked == nullptr || control.blocks_alive > 0) return;
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
