#include "analyzer/machine/firing.hpp"

namespace pal::analyzer {

Firing::Firing(const Machine& machine, Choices& choices, bool record, Outcome& outcome)
    : machine_(machine),
      problem_(machine.problem()),
      watch_(machine.watch()),
      choices_(choices),
      record_(record),
      outcome_(outcome),
      state_(outcome.state),
      old_observers_(outcome.state.observers) {
  start_tracking();
}

void Firing::start_timer(int timer, Range range) {
  outcome_.changes.push_back({TimerChange::Kind::start, timer, range});
}

void Firing::stop_timer(int timer) {
  outcome_.changes.push_back({TimerChange::Kind::stop, timer, {}});
}

void Firing::emit(Kind kind, ThreadId thread, int subject, int value) {
  if (!record_) return;
  const StepId step = state_of(thread).at();
  const StatementId statement = !step.valid() ? StatementId{} : problem_.steps[step].statement;
  outcome_.events.push_back({0, kind, thread.value, statement.value, subject, value});
}

void Firing::emit_device(Kind kind, DeviceId device, int subject, int value) {
  if (!record_) return;
  const int actor = static_cast<int>(problem_.threads.size()) + device.value;
  outcome_.events.push_back({0, kind, actor, -1, subject, value});
}

void Firing::fire(int timer) {
  const bool was_busy = watched_busy();
  if (machine_.is_of_thread(timer)) {
    const ThreadId thread = machine_.thread_of(timer);
    if (is_loose(thread)) {
      loosened(thread);
    } else if (state_of(thread).status == Status::waiting) {
      emit(Kind::give_up, thread, step_of(thread).channels.front());
      state_of(thread).choice = ThreadState::gives_up;
      need_processor(thread);
    } else {
      effect(thread);
    }
  } else if (timer < machine_.first_device_timer()) {
    const ChannelId channel = machine_.channel_of(timer);
    SlotState& of = slot(channel);
    (timer == machine_.flight_timer(channel) ? of.near : of.far) = SlotState::Way::there;
    if (of.fill == SlotState::Fill::full) message_available(channel);
  } else if (timer == machine_.pause_timer()) {
    state_.reference = tag::none;
  } else {
    const DeviceId device = machine_.device_of(timer);
    if (timer == machine_.next_timer(device)) {
      device_next(device);
    } else {
      device_service(device);
    }
  }
  all_due();
  if (!state_.ended) dispatch();
  let_change();
  track_busy(was_busy);
  settle();
}

void Firing::effect(ThreadId thread) {
  switch (step_of(thread).kind) {
    case Step::Kind::wait:
      effect_wait(thread);
      return;
    case Step::Kind::send:
      effect_send(thread);
      return;
    case Step::Kind::set:
      effect_set(thread);
      return;
    case Step::Kind::read: {
      const ConditionId condition = step_of(thread).condition;
      const bool value = read(thread, condition);
      const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(condition.index());
      state_of(thread).latched |= bit;
      if (value) {
        state_of(thread).latched_values |= bit;
      } else {
        state_of(thread).latched_values &= ~bit;
      }
      measure(thread);
      finish(thread, step_of(thread).next.front());
      return;
    }
    case Step::Kind::test:
      effect_test(thread);
      return;
    case Step::Kind::activity:
      uses_kept(thread);
      measure(thread);
      has_written(thread);
      finish(thread, step_of(thread).next.front());
      return;
    case Step::Kind::complete:
      measure(thread);
      complete(thread, step_of(thread).code);
      return;
    case Step::Kind::fork:
    case Step::Kind::end:
      return;
  }
}

void Firing::finish(ThreadId thread, StepId next) {
  emit(Kind::done, thread);
  if (state_.ended) return;
  has_done(thread);
  if (state_of(thread).cancelled) {
    stop(thread);
  } else {
    reach(thread, next);
  }
}

void Firing::complete(ThreadId thread, int code) {
  has_completed(thread, code);
  emit(Kind::complete, thread, -1, code);
  emit(Kind::done, thread);
  state_.ended = true;
}

void Firing::effect_wait(ThreadId thread) {
  const Step& step = step_of(thread);
  ThreadState& state = state_of(thread);
  if (state.choice == ThreadState::withdrawn) {
    if (state.cancelled) {
      stop(thread);
    } else {
      reach(thread, state.at());
    }
    return;
  }
  if (state.choice == ThreadState::gives_up) {
    std::vector<ChannelId> freed;
    for (ChannelId channel : step.channels) {
      if (channel_of(channel).answers.valid()) withdraw_all(channel_of(channel).answers, freed);
    }
    measure(thread);
    go_on_and_admit(thread, step.next.back(), freed);
    return;
  }
  const auto branch = static_cast<std::size_t>(state.choice);
  if (ends_loosely(step, branch)) return effect_loose_wait(thread, branch);
  const ChannelId channel = step.channels[branch];
  take(channel, thread, DeviceId{});
  state.choice = ThreadState::no_choice;
  clear(channel);
  measure(thread);
  go_on_and_admit(thread, step.next[branch], {channel});
}

/// The thread goes on, and the channels are there for senders that are blocked.
void Firing::go_on_and_admit(ThreadId thread, StepId next, std::vector<ChannelId> channels) {
  std::erase_if(channels, [this](ChannelId channel) { return !somebody_sends(channel); });
  if (state_of(thread).cancelled) {
    in_any_order(std::move(channels), [this](ChannelId channel) { admit(channel); });
    finish(thread, next);
    return;
  }
  for (ChannelId channel : channels) admit_later(channel);
  go_on_later(thread, next);
}

void Firing::effect_send(ThreadId thread) {
  const ChannelId channel = step_of(thread).channels.front();
  if (channel_of(channel).loose) return effect_loose_send(thread);
  SlotState& to = slot(channel);
  if (discards(channel)) {
    discard(channel);
    emit(Kind::drop, thread, channel);
    sent(thread, false);
    return;
  }
  if (to.fill != SlotState::Fill::empty) {
    if (state_of(thread).cancelled) {
      stop(thread);
      return;
    }
    leave_processor(thread);
    state_of(thread).status = Status::sending;
    emit(Kind::block, thread, channel);
    return;
  }
  sent(thread, true);
}

/// The effect of a send: of the thread that has just done it, or of one that was blocked in it.
void Firing::sent(ThreadId thread, bool put_it) {
  const Step& step = step_of(thread);
  uses_kept(thread);
  const std::uint8_t carries = sent_along(thread);
  const ChannelId channel = step.channels.front();
  if (put_it) place(channel, thread, DeviceId{}, carries);
  measure(thread);
  if (state_of(thread).cancelled) {
    if (put_it) announce(channel);
    finish(thread, step.next.front());
    return;
  }
  if (put_it) announce(channel);
  go_on_later(thread, step.next.front());
}

void Firing::effect_set(ThreadId thread) {
  const Step& step = step_of(thread);
  const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(step.condition.index());
  const bool free = (problem_.free_conditions & bit) != 0;
  const bool value = step.value ? *step.value && !free : !free && choices_.pick(2) == 1;
  state_.conditions = value ? state_.conditions | bit : state_.conditions & ~bit;
  state_.held &= ~bit;
  emit(Kind::set, thread, step.condition.value, value ? 1 : 0);
  uses_kept(thread);
  has_set(thread, step.condition);
  measure(thread);
  finish(thread, step.next.front());
}

bool Firing::read(ThreadId thread, ConditionId condition) {
  const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(condition.index());
  bool value = (state_.conditions & bit) != 0;
  const bool free = ((machine_.free_conditions | problem_.free_conditions) & bit) != 0;
  if (free && (state_.held & bit) == 0) value = choices_.pick(2) == 1;
  if (free) hold(condition, value);
  emit(Kind::read, thread, condition.value, value ? 1 : 0);
  has_read(thread, condition);
  return value;
}

namespace {

std::uint64_t mentioned(const pan::Guard& guard) {
  if (guard.kind == pan::Guard::Kind::equals)
    return std::uint64_t{1} << static_cast<unsigned>(guard.condition.value);
  std::uint64_t all = 0;
  for (const pan::Guard& term : guard.terms) all |= mentioned(term);
  return all;
}

bool value_of(const pan::Guard& guard, std::uint64_t values) {
  switch (guard.kind) {
    case pan::Guard::Kind::equals:
      return ((values >> static_cast<unsigned>(guard.condition.value) & 1U) != 0) == guard.value;
    case pan::Guard::Kind::negation:
      return !value_of(guard.terms.front(), values);
    case pan::Guard::Kind::all_of:
      for (const pan::Guard& term : guard.terms) {
        if (!value_of(term, values)) return false;
      }
      return true;
    case pan::Guard::Kind::any_of:
      for (const pan::Guard& term : guard.terms) {
        if (value_of(term, values)) return true;
      }
      return false;
  }
  return false;
}

}  // namespace

/// Latched values where there are some, the rest read now.
std::uint64_t Firing::values_for_test(ThreadId thread, const Step& step) {
  std::uint64_t all = 0;
  for (const pan::Guard& guard : step.guards) all |= mentioned(guard);
  std::uint64_t values = state_of(thread).latched_values & state_of(thread).latched;
  for (std::size_t condition = 0; condition < problem_.conditions.size(); ++condition) {
    const std::uint64_t bit = std::uint64_t{1} << condition;
    if ((all & bit) == 0 || (state_of(thread).latched & bit) != 0) continue;
    if (read(thread, ConditionId(condition))) values |= bit;
  }
  return values;
}

void Firing::effect_test(ThreadId thread) {
  const Step& step = step_of(thread);
  const std::uint64_t values = values_for_test(thread, step);
  state_of(thread).latched = 0;
  state_of(thread).latched_values = 0;
  measure(thread);
  for (std::size_t i = 0; i < step.guards.size(); ++i) {
    if (value_of(step.guards[i], values)) {
      finish(thread, step.next[i]);
      return;
    }
  }
  if (step.next.size() > step.guards.size()) {
    finish(thread, step.next.back());
  } else {
    complete(thread, problem_.error_code);
  }
}

}  // namespace pal::analyzer
