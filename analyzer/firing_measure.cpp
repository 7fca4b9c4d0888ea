// What is carried along to be measured.
#include <algorithm>

#include "analyzer/firing.hpp"

namespace pal::analyzer {

namespace {
constexpr std::size_t most_pending = 8;
}

void Firing::start_tracking() {
  old_observers_ = state_.observers;
  int number = 0;
  for (Pending pending : state_.pending) {
    pending_origin_.push_back(pending == Pending::observed ? number++ : Outcome::older_than_cap);
  }
  // Until the first set, what a condition says dates from the start.
  const bool at_start = state_.threads.empty() || state_.threads.front().step < 0;
  if (watch_.kind == Watch::Kind::age && at_start && old_observers_ == 0 &&
      state_.condition_carries == tag::none) {
    state_.condition_carries = 0;
    old_observers_ = 0;
  }
}

void Firing::measure(int thread) {
  if (watch_.kind == Watch::Kind::nothing) return;
  const auto step = static_cast<std::size_t>(state_of(thread).step);
  const std::uint8_t carries = state_of(thread).carries;
  if (!watch_.at[step] || carries == tag::none) return;
  outcome_.measured_steps.push_back(static_cast<int>(step));
  if (watch_.kind == Watch::Kind::age) {
    if (carries == tag::over) {
      outcome_.measured.push_back(Outcome::older_than_cap);
    } else {
      outcome_.measured.push_back(carries < old_observers_ ? carries : Outcome::born_now);
    }
    return;
  }
  outcome_.measured.push_back(pending_origin_[carries]);
  if (carries != 0) state_.failed = true;  // an older one is still unanswered
  answered(carries);
}

void Firing::has_read(int thread, int condition) {
  if (watch_.kind == Watch::Kind::age && watch_.condition == condition) {
    state_of(thread).carries = state_.condition_carries;
  }
}

void Firing::has_set(int condition) {
  if (watch_.kind == Watch::Kind::age && watch_.condition == condition) {
    state_.condition_carries = static_cast<std::uint8_t>(old_observers_);
  }
}

/// A message without an event leaves the thread with the one that it has.
void Firing::has_taken(int thread, std::uint8_t carries) {
  if (watch_.kind == Watch::Kind::response && carries != tag::none) state_of(thread).carries = carries;
}

std::uint8_t Firing::new_event(int channel) {
  if (watch_.kind != Watch::Kind::response || watch_.event != channel) return tag::none;
  if (state_.pending.size() >= most_pending) {
    outcome_.too_many = true;
    return tag::none;
  }
  state_.pending.push_back(Pending::observed);
  pending_origin_.push_back(Outcome::born_now);
  return static_cast<std::uint8_t>(state_.pending.size() - 1);
}

void Firing::answered(std::uint8_t event) {
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
}

/// Forgets what cannot count any more and numbers the rest in a fixed order, so that states that behave alike
/// are alike.
void Firing::settle() {
  if (watch_.kind == Watch::Kind::age) settle_age();
  if (watch_.kind == Watch::Kind::response) settle_response();
}

void Firing::settle_age() {
  bool ahead = false;
  for (ThreadState& thread : state_.threads) {
    if (state_.ended || thread.status == Status::off) {
      thread.carries = tag::none;
      continue;
    }
    const auto step = static_cast<std::size_t>(thread.step);
    if (!watch_.counts[step]) thread.carries = tag::none;
    ahead = ahead || watch_.read_ahead[step];
  }
  if (!ahead) state_.condition_carries = tag::none;
  std::vector<std::uint8_t> order;
  const auto number = [&](std::uint8_t& carries) {
    if (carries >= tag::over) return;
    const auto known = std::find(order.begin(), order.end(), carries);
    if (known == order.end()) {
      order.push_back(carries);
      carries = static_cast<std::uint8_t>(order.size() - 1);
    } else {
      carries = static_cast<std::uint8_t>(known - order.begin());
    }
  };
  number(state_.condition_carries);
  for (ThreadState& thread : state_.threads) number(thread.carries);
  for (std::uint8_t before : order)
    outcome_.origin.push_back(before < old_observers_ ? before : Outcome::born_now);
  state_.observers = static_cast<std::uint8_t>(order.size());
}

void Firing::settle_response() {
  std::vector<bool> carried(state_.pending.size());
  const auto mark = [&carried](std::uint8_t carries) {
    if (carries != tag::none) carried[carries] = true;
  };
  for (const ThreadState& thread : state_.threads) mark(thread.carries);
  for (const SlotState& of : state_.slots) {
    mark(of.carries);
    mark(of.serving_carries);
  }
  std::vector<std::uint8_t> moved(state_.pending.size(), tag::none);
  std::vector<Pending> pending;
  for (std::size_t i = 0; i < state_.pending.size(); ++i) {
    const Pending now = carried[i] ? state_.pending[i] : Pending::lost;
    if (now == Pending::lost && !pending.empty() && pending.back() == Pending::lost) continue;
    if (now == Pending::observed) outcome_.origin.push_back(pending_origin_[i]);
    moved[i] = static_cast<std::uint8_t>(pending.size());
    pending.push_back(now);
  }
  const auto move = [&moved](std::uint8_t& carries) {
    if (carries != tag::none) carries = moved[carries];
  };
  for (ThreadState& thread : state_.threads) move(thread.carries);
  for (SlotState& of : state_.slots) {
    move(of.carries);
    move(of.serving_carries);
  }
  state_.pending = std::move(pending);
  state_.observers = static_cast<std::uint8_t>(outcome_.origin.size());
}

}  // namespace pal::analyzer
