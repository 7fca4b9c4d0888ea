// What is carried along to be measured.
#include <algorithm>

#include "analyzer/machine/firing.hpp"

namespace pal::analyzer {

namespace {
constexpr std::size_t most_pending = 8;
}

void Firing::start_tracking() {
  int number = 0;
  for (Pending pending : state_.pending) {
    const bool observed = pending == Pending::observed || pending == Pending::lost;
    pending_origin_.push_back(observed ? number++ : Outcome::older_than_cap);
  }
}

/// The value from `observer` until now.
void Firing::measure_from(std::uint8_t observer, StepId step) {
  outcome_.measured_steps.push_back(step);
  if (observer == tag::over) {
    outcome_.measured.push_back(Outcome::older_than_cap);
  } else {
    outcome_.measured.push_back(observer < old_observers_ ? observer : Outcome::born_now);
  }
}

/// At the effect of the thread's statement. Of a phase it is asked as the thread goes on.
void Firing::measure(ThreadId thread) {
  if (!limited()) measure_now(thread);
}

void Firing::measure_now(ThreadId thread) {
  const StepId step = state_of(thread).at();
  if (watch_.kind == Watch::Kind::nothing || !watch_.at[step]) return;
  const bool counted = counts();
  outcome_.passed = outcome_.passed || counted;
  if (!counted && watch_.kind != Watch::Kind::response) return;
  const std::uint8_t carries = state_of(thread).carries;
  switch (watch_.kind) {
    case Watch::Kind::age:
    case Watch::Kind::sample:
      if (!watch_.reaction) {
        if (carries != tag::none) measure_from(carries, step);
      } else if (tag::newer(carries, state_.reference) && state_.reference != tag::none) {
        measure_from(state_.reference, step);
        state_.reference = carries == tag::over_later ? tag::over : carries;
      }
      return;
    case Watch::Kind::response:
      if (carries == tag::none) return;
      if (state_.pending[carries] != Pending::outside) {
        outcome_.measured_steps.push_back(step);
        outcome_.measured.push_back(pending_origin_[carries]);
        // An older one is still unanswered.
        const auto older = state_.pending.begin() + carries;
        const bool waits = std::any_of(state_.pending.begin(), older,
                                       [](Pending pending) { return pending != Pending::outside; });
        if (waits) state_.failed = true;
      }
      forget_event(carries);
      return;
    case Watch::Kind::interval:
      if (state_.reference != tag::none) measure_from(state_.reference, step);
      state_.reference = now();
      return;
    default:
      return;
  }
}

void Firing::has_completed(ThreadId thread, int code) {
  if (watch_.kind != Watch::Kind::duration || watch_.code != code) return;
  if (!counts()) return;
  outcome_.passed = true;
  measure_from(state_.reference, state_of(thread).at());
}

bool Firing::watched_busy() const {
  return watch_.kind == Watch::Kind::busy && state_.running[watch_.processor] >= 0;
}

/// A processor that ends one action and begins another in one event has not paused. It may begin another one
/// in a later event of the same instant. Then the pause may be counted or not, because the timer of the pause
/// may come before.
void Firing::track_busy(bool was_busy) {
  if (watch_.kind != Watch::Kind::busy) return;
  const bool busy = !state_.ended && watched_busy();
  if (was_busy && !busy) {
    measure_from(state_.reference, StepId{});
    if (!state_.ended) start_timer(machine_.pause_timer(), {0, 0});
  }
  const bool pauses = !was_busy && state_.reference != tag::none;
  if (pauses && (busy || state_.ended)) stop_timer(machine_.pause_timer());
  if (was_busy || !busy) return;
  outcome_.passed = true;
  if (!pauses) state_.reference = now();
}

void Firing::has_read(ThreadId thread, ConditionId condition) {
  std::uint8_t& carries = state_of(thread).carries;
  if (watch_.kind == Watch::Kind::age && watch_.condition == condition) carries = state_.condition_carries;
  if (watch_.kind == Watch::Kind::sample) {
    const std::uint8_t known = state_.known[condition];
    if (tag::newer(known, carries)) carries = known;
  }
}

void Firing::has_set(ThreadId thread, ConditionId condition) {
  if (watch_.kind == Watch::Kind::age && watch_.condition == condition) {
    state_.condition_carries = now();
  }
  if (watch_.kind == Watch::Kind::sample) {
    state_.known[condition] = state_of(thread).carries;
  }
}

/// A message without an event leaves the thread with the one that it has, one with an older sample likewise.
void Firing::has_taken(ThreadId thread, ChannelId channel, std::uint8_t carries) {
  const KeptId kept = channel_of(channel).kept;
  if (watch_.kind == Watch::Kind::sample && kept.valid()) state_.kept[kept] = carries;
  std::uint8_t& own = state_of(thread).carries;
  if (watch_.kind == Watch::Kind::response && carries != tag::none) own = carries;
  if (watch_.kind == Watch::Kind::sample && tag::newer(carries, own)) own = carries;
}

/// The statement uses what its module keeps: its thread knows the samples of that from then on.
void Firing::uses_kept(ThreadId thread) {
  if (watch_.kind != Watch::Kind::sample) return;
  std::uint8_t& own = state_of(thread).carries;
  for (const KeptId kept : step_of(thread).uses) {
    const std::uint8_t carries = state_.kept[kept];
    if (tag::newer(carries, own)) own = carries;
  }
}

void Firing::has_written(ThreadId thread) {
  if (watch_.kind != Watch::Kind::sample) return;
  for (const KeptId kept : step_of(thread).writes) state_.kept[kept] = state_of(thread).carries;
}

std::uint8_t Firing::sent_along(ThreadId thread) const {
  const bool along = watch_.kind == Watch::Kind::response || watch_.kind == Watch::Kind::sample;
  return along ? state_of(thread).carries : tag::none;
}

/// A sample that is taken now. With the first that counts a reaction begins.
std::uint8_t Firing::new_sample() {
  if (watch_.reaction && limited()) state_.counting = true;
  if (watch_.reaction && counts() && state_.reference == tag::none) state_.reference = now();
  return now();
}

/// What the answer to a request will carry: the event of the request, or a sample that is taken now.
std::uint8_t Firing::sampled(ChannelId request) {
  if (watch_.kind == Watch::Kind::response) return slot(request).carries;
  if (watch_.kind != Watch::Kind::sample) return tag::none;
  if (!watch_.samples[channel_of(request).answer]) return tag::none;
  return new_sample();
}

/// What the message of a device's event carries, if no response to it is awaited.
std::uint8_t Firing::occurred(ChannelId channel) {
  if (counts_losses(channel_of(channel).sender_device)) return counts() ? std::uint8_t{0} : tag::none;
  if (watch_.kind == Watch::Kind::sample && watch_.samples[channel]) {
    return new_sample();
  }
  return tag::none;
}

/// Whether messages of the channel are what is to be responded to.
bool Firing::awaits_response(ChannelId channel) const {
  return watch_.kind == Watch::Kind::response && watch_.events[channel];
}

/// What such a message carries.
std::uint8_t Firing::new_event() {
  if (state_.pending.size() >= most_pending) {
    outcome_.too_many = true;
    return tag::none;
  }
  state_.pending.push_back(counts() ? Pending::observed : Pending::outside);
  pending_origin_.push_back(counts() ? Outcome::born_now : Outcome::older_than_cap);
  return static_cast<std::uint8_t>(state_.pending.size() - 1);
}

/// It is answered, or withdrawn: its response is no longer awaited.
void Firing::forget_event(std::uint8_t event) {
  outcome_.over_gone = outcome_.over_gone || state_.pending[event] == Pending::over;
  state_.pending.erase(state_.pending.begin() + event);
  pending_origin_.erase(pending_origin_.begin() + event);
  const auto move = [event](std::uint8_t& carries) {
    if (carries == tag::none) return;
    if (carries == event) {
      carries = tag::none;
    } else if (carries > event) {
      --carries;
    }
  };
  for (ThreadState& thread : state_.threads) move(thread.carries);
  for (SlotState& of : state_.slots) {
    move(of.carries);
    move(of.serving_carries);
  }
  for (Due& due : due_) move(due.carries);
}

}  // namespace pal::analyzer
