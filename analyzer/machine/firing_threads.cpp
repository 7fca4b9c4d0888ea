// Threads and processors: which thread runs, waits its turn, begins and ends.
#include <algorithm>

#include "analyzer/machine/firing.hpp"

namespace pal::analyzer {

/// At time 0 every module becomes ready; those that share a queue may come in any order.
void Firing::begin() {
  if (watch_.kind == Watch::Kind::age) state_.condition_carries = 0;
  const bool begins =
      watch_.kind == Watch::Kind::duration || (watch_.kind == Watch::Kind::age && watch_.reaction);
  if (begins && !limited()) state_.reference = 0;
  for (const DeviceId d : problem_.devices.ids()) {
    const auto* frames = std::get_if<pan::FrameDevice>(&problem_.devices[d].behaviour);
    if (frames == nullptr) continue;
    state_.devices[d].open = true;
    Range first = frames->phase ? Range{frames->phase->count(), frames->phase->count()}
                                : Range{0, frames->period.count()};
    if (problem_.devices[d].seldom) first = {0, Range::unbounded};
    start_timer(machine_.next_timer(d), first);
  }
  std::vector<ThreadId> modules;
  for (const ThreadId t : problem_.threads.ids()) {
    const Thread& thread = problem_.threads[t];
    if (!thread.parent.valid() && !thread.left_out) modules.push_back(t);
  }
  while (!modules.empty()) {
    const std::vector<std::size_t> rivals = rivals_of_first(modules);
    const std::size_t chosen = rivals[static_cast<std::size_t>(
        rivals.size() == 1 ? 0 : choices_.pick(static_cast<int>(rivals.size())))];
    const ThreadId thread = modules[chosen];
    modules.erase(modules.begin() + static_cast<std::ptrdiff_t>(chosen));
    state_of(thread).status = Status::ready;
    reach(thread, thread_of(thread).entry);
    all_due();
  }
  dispatch();
  track_busy(false);
  settle();
}

/// The queues that a thread, or its blocks, may come to as it begins at `step`: none if it waits. Blocks that
/// are over at once lead on to what is behind them.
void Firing::first_queues(ThreadId thread, StepId step, std::set<StepId>& seen,
                          std::set<Queue>& queues) const {
  if (!seen.insert(step).second) return;
  const Step& first = problem_.steps[step];
  if (first.kind == Step::Kind::end) return;
  if (first.kind == Step::Kind::wait && !(first.within && *first.within == 0)) return;
  if (first.kind != Step::Kind::fork) {
    queues.emplace(thread_of(thread).processor, thread_of(thread).priority);
    return;
  }
  for (ThreadId block : first.threads) first_queues(block, thread_of(block).entry, seen, queues);
  first_queues(thread, first.next.front(), seen, queues);
}

/// Which of `modules` may become ready before the first of them, if that matters to any party: positions, the
/// first's too.
std::vector<std::size_t> Firing::rivals_of_first(const std::vector<ThreadId>& modules) const {
  std::vector<std::set<Queue>> queues(modules.size());
  for (std::size_t i = 0; i < modules.size(); ++i) {
    std::set<StepId> seen;
    first_queues(modules[i], thread_of(modules[i]).entry, seen, queues[i]);
  }
  std::set<Queue> shared = queues.front();
  std::vector<std::size_t> rivals{0};
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t i = 1; i < modules.size(); ++i) {
      if (std::find(rivals.begin(), rivals.end(), i) != rivals.end()) continue;
      const bool meets = std::any_of(queues[i].begin(), queues[i].end(),
                                     [&shared](const auto& queue) { return shared.contains(queue); });
      if (!meets) continue;
      rivals.push_back(i);
      shared.insert(queues[i].begin(), queues[i].end());
      grown = true;
    }
  }
  return rivals;
}

/// The thread comes to a statement. That needs no processor and is one with what led to it.
void Firing::reach(ThreadId thread, StepId step) {
  state_of(thread).go_to(step);
  state_of(thread).begun = false;
  state_of(thread).choice = ThreadState::no_choice;
  follow_phase();
  switch (step_of(thread).kind) {
    case Step::Kind::end:
      end(thread);
      return;
    case Step::Kind::fork:
      fork(thread);
      return;
    case Step::Kind::wait:
      reach_wait(thread);
      return;
    default:
      need_processor(thread);
  }
}

void Firing::reach_wait(ThreadId thread) {
  const Step& step = step_of(thread);
  for (ChannelId channel : step.channels) {
    if (channel_of(channel).sender_device.valid()) open_device(channel_of(channel).sender_device);
  }
  if (step.channels.empty() && step.next.size() > 1 && choices_.pick(2) == 1) {
    state_of(thread).choice = static_cast<std::int8_t>(loose_branch(step, false));
    need_processor(thread);
    return;
  }
  for (std::size_t i = 0; i < step.channels.size(); ++i) {
    const bool loose = channel_of(step.channels[i]).loose;
    const bool at_once = step.arrival.best == 0;
    if (loose ? !at_once || choices_.pick(2) == 0 : !available(step.channels[i], thread)) continue;
    if (!loose) slot(step.channels[i]).fill = SlotState::Fill::claimed;
    state_of(thread).choice = static_cast<std::int8_t>(i);
    need_processor(thread);
    return;
  }
  if (step.within && *step.within == 0) {
    state_of(thread).choice = ThreadState::gives_up;
    emit(Kind::give_up, thread, step.channels.front());
    need_processor(thread);
    return;
  }
  leave_processor(thread);
  state_of(thread).status = Status::waiting;
  emit(Kind::block, thread, step.channels.empty() ? ChannelId{} : step.channels.front());
  if (is_loose(thread)) {
    wait_loosely(thread);
  } else if (step.within) {
    start_timer(machine_.thread_timer(thread), {*step.within, *step.within});
  }
}

void Firing::fork(ThreadId thread) {
  leave_processor(thread);
  state_of(thread).status = Status::joining;
  emit(Kind::block, thread);
  const std::vector<ThreadId>& blocks = step_of(thread).threads;
  for (ThreadId block : blocks) {
    ThreadState fresh;
    fresh.status = Status::ready;
    fresh.carries = state_of(thread).carries;
    state_of(block) = fresh;
  }
  for (ThreadId block : blocks) {
    if (state_of(block).status != Status::off && !state_.ended) reach(block, thread_of(block).entry);
  }
}

/// With a new statement: keeps the processor, or queues for it.
void Firing::need_processor(ThreadId thread) {
  ThreadState& state = state_of(thread);
  state.begun = false;
  if (state.status == Status::running) return;
  state.status = Status::ready;
  enqueue(thread, false);
  queued_.push_back(thread);
}

void Firing::leave_processor(ThreadId thread) {
  if (state_of(thread).status == Status::running) running(thread_of(thread).processor) = -1;
  dequeue(thread);
}

void Firing::dequeue(ThreadId thread) {
  std::erase(state_.queue, number_of(thread));
}

void Firing::enqueue(ThreadId thread, bool front) {
  const Thread& of = thread_of(thread);
  const auto behind = [&](ThreadNumber other) {  // whether `other` stands behind the new one
    const Thread& o = thread_of(ThreadId::of(other));
    if (o.processor != of.processor) return o.processor > of.processor;
    if (o.priority != of.priority) return o.priority < of.priority;
    return front;
  };
  const auto place = std::find_if(state_.queue.begin(), state_.queue.end(), behind);
  state_.queue.insert(place, static_cast<ThreadNumber>(thread.index()));
}

void Firing::end(ThreadId thread) {
  leave_processor(thread);
  ThreadState off;
  state_of(thread) = off;
  follow_phase();
  if (thread_of(thread).parent.valid()) hand_over(thread, thread_of(thread).parent);
  if (thread_of(thread).parent.valid()) child_ended(thread_of(thread).parent, false);
}

/// A block has ended, or was stopped. When all that can end have, the others are cancelled. When all are
/// over, the parent goes on at once. If the last one was stopped, other threads may go on as well, and the
/// parent goes on before or after them.
void Firing::child_ended(ThreadId parent, bool stopped) {
  ThreadState& state = state_of(parent);
  if (state.status != Status::joining) return;
  std::vector<ThreadId> blocks = step_of(parent).threads;
  bool alive = false;
  bool goes_on = false;
  bool can_end = false;
  for (ThreadId block : blocks) {
    const bool here = state_of(block).status != Status::off;
    alive = alive || here;
    goes_on = goes_on || (here && thread_of(block).can_end);
    can_end = can_end || thread_of(block).can_end;
  }
  if (alive) {
    if (!state.cancelled && (goes_on || !can_end)) return;
    std::erase_if(blocks, [this](ThreadId block) {
      return state_of(block).status == Status::off || state_of(block).cancelled;
    });
    cancel_all(std::move(blocks));
    return;
  }
  if (state.cancelled) {
    state.status = Status::ready;
    stop(parent);
  } else if (stopped) {
    due_.push_back({Due::What::parent, parent.value});
  } else {
    go_on_behind_blocks(parent);
  }
}

void Firing::go_on_behind_blocks(ThreadId parent) {
  state_of(parent).status = Status::ready;
  reach(parent, step_of(parent).next.front());
}

/// In the order of the text, unless one of them leaves a message to others that another has asked for.
void Firing::cancel_all(std::vector<ThreadId> blocks) {
  for (ThreadId block : blocks) state_of(block).cancelled = true;
  // Stopping the last one lets the parent go on, perhaps to blocks that begin: those are not meant.
  const auto cancel_one = [this](ThreadId block) {
    if (state_of(block).status != Status::off && state_of(block).cancelled) cancel(block);
  };
  bool ordered = true;
  for (const ThreadId t : problem_.threads.ids()) ordered = ordered && !leaves_answer_to_others(t);
  if (!ordered) return in_any_order(std::move(blocks), cancel_one);
  for (ThreadId block : blocks) cancel_one(block);
}

/// Whether, if it were stopped now, a message that one thread has asked for might be taken by another.
bool Firing::leaves_answer_to_others(ThreadId thread) const {
  const ThreadState& state = state_of(thread);
  if (state.choice < 0 || step_of(thread).channels.empty()) return false;
  const ChannelId channel = step_of(thread).channels[static_cast<std::size_t>(state.choice)];
  return state_.slots[channel].answers && !waiting_for(channel).empty();
}

/// A thread that is cancelled stops, or will when it has finished its statement.
void Firing::cancel(ThreadId thread) {
  const ThreadState& state = state_of(thread);
  if (state.status == Status::joining) {
    child_ended(thread, true);
    return;
  }
  const bool busy = state.begun && (state.status == Status::running || state.status == Status::ready);
  if (!busy && !finishes_first(thread)) stop(thread);
}

void Firing::stop(ThreadId thread) {
  emit(Kind::cancel, thread);
  stop_waiting(thread);
  leave_processor(thread);
  const bool goes_on = std::any_of(due_.begin(), due_.end(), [thread](const Due& due) {
    return due.what == Due::What::go_on && ThreadId::of(due.who) == thread;
  });
  if (goes_on && limited()) measure_now(thread);
  state_of(thread).status = Status::off;
  forget(thread);
  const std::vector<ChannelId> freed = abandon(thread);
  state_of(thread) = {};
  follow_phase();
  for (ChannelId channel : freed) admit_later(channel);
  if (thread_of(thread).parent.valid()) child_ended(thread_of(thread).parent, true);
}

void Firing::dispatch() {
  for (const ProcessorId p : problem_.processors.ids()) dispatch(p);
  for (ThreadId thread : queued_) {
    if (state_of(thread).status == Status::ready && !state_of(thread).begun) emit(Kind::ready, thread);
  }
}

void Firing::dispatch(ProcessorId processor) {
  ThreadId first{};
  for (ThreadNumber queued : state_.queue) {
    if (thread_of(ThreadId::of(queued)).processor == processor) {
      first = ThreadId::of(queued);
      break;
    }
  }
  auto current = ThreadId::of(running(processor));
  if (current.valid() && first.valid() && problem_.processors[processor].preemptive &&
      thread_of(first).priority > thread_of(current).priority) {
    if (state_of(current).begun) {
      outcome_.changes.push_back({TimerChange::Kind::freeze, machine_.thread_timer(current), {}});
      emit(Kind::stop, current);
    } else {
      queued_.push_back(current);
    }
    state_of(current).status = Status::ready;
    enqueue(current, true);
    current = ThreadId{};
  }
  if (!current.valid() && first.valid()) {
    dequeue(first);
    current = first;
    state_of(current).status = Status::running;
    running(processor) = number_of(current);
    if (state_of(current).begun) {
      outcome_.changes.push_back({TimerChange::Kind::resume, machine_.thread_timer(current), {}});
      emit(Kind::start, current);
      return;
    }
  }
  if (current.valid() && !state_of(current).begun) {
    state_of(current).begun = true;
    start_timer(machine_.thread_timer(current), machine_.cost(state_, machine_.thread_timer(current)));
    emit(Kind::start, current);
  }
}

}  // namespace pal::analyzer
