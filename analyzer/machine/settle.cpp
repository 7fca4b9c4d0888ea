// Forgets what cannot count any more and numbers the rest in a fixed order, so that states that behave alike
// are alike.
#include <algorithm>

#include "analyzer/machine/firing.hpp"

namespace pal::analyzer {

void Firing::settle() {
  switch (watch_.kind) {
    case Watch::Kind::nothing:
    case Watch::Kind::loss:
      return;
    case Watch::Kind::response:
      return settle_response();
    case Watch::Kind::age:
      return watch_.reaction ? settle_ordered() : settle_age();
    case Watch::Kind::sample:
    case Watch::Kind::interval:
    case Watch::Kind::duration:
    case Watch::Kind::busy:
      return settle_ordered();
  }
}

/// Whether a statement at which something is measured can still come.
bool Firing::any_live() const {
  if (state_.ended) return false;
  if (watch_.kind == Watch::Kind::busy) return true;
  return std::any_of(state_.threads.begin(), state_.threads.end(),
                     [this](const ThreadState& thread) { return is_live(thread); });
}

/// Whether it can come from where the thread itself is.
bool Firing::is_live(const ThreadState& thread) const {
  if (thread.status == Status::off) return false;
  const StepId at = thread.at();
  if (thread.cancelled) return watch_.at[at];
  if (thread.status != Status::joining) return watch_.live[at];
  // Its blocks count for themselves.
  const Step& fork = problem_.steps[at];
  const bool goes_on = std::any_of(fork.threads.begin(), fork.threads.end(),
                                   [this](ThreadId block) { return problem_.threads[block].can_end; });
  return goes_on && watch_.live[fork.next.front()];
}

/// Observers in the order of their birth, which is what newer and older are told by.
void Firing::settle_ordered() {
  const bool live = any_live();
  std::vector<std::uint8_t*> carried;
  const auto keep = [&](std::uint8_t& carries, bool counts) {
    if (!live || !counts) carries = tag::none;
    if (carries == tag::over_later && state_.reference != tag::over) carries = tag::over;
    if (carries < tag::over) carried.push_back(&carries);
  };
  keep(state_.reference, true);
  bool ahead = false;
  for (ThreadState& thread : state_.threads) {
    const StepId step = thread.at();
    const bool on = thread.status != Status::off;
    keep(thread.carries, on && watch_.counts[step]);
    ahead = ahead || (on && watch_.read_ahead[step]);
  }
  keep(state_.condition_carries, ahead);
  if (watch_.kind == Watch::Kind::sample) {
    for (const ConditionId c : state_.known.ids())
      keep(state_.known[c], (watch_.condition_counts >> c.index() & 1U) != 0);
    for (const KeptId k : state_.kept.ids()) keep(state_.kept[k], watch_.kept_counts[k]);
    for (const ChannelId c : state_.slots.ids()) {
      keep(state_.slots[c].carries, watch_.message_counts[c]);
      const ChannelId answer = channel_of(c).answer;
      keep(state_.slots[c].serving_carries, answer.valid() && watch_.message_counts[answer]);
    }
  }
  std::vector<std::uint8_t> order;
  for (const std::uint8_t* carries : carried) order.push_back(*carries);
  std::sort(order.begin(), order.end());
  order.erase(std::unique(order.begin(), order.end()), order.end());
  if (order.size() > tag::most) {
    outcome_.too_many = true;
    order.resize(tag::most);
  }
  for (std::uint8_t* carries : carried) {
    const auto place = std::lower_bound(order.begin(), order.end(), *carries);
    *carries = place == order.end() ? tag::none : static_cast<std::uint8_t>(place - order.begin());
  }
  for (const std::uint8_t before : order) {
    outcome_.origin.push_back(before < old_observers_ ? before : Outcome::born_now);
  }
  state_.observers = static_cast<std::uint8_t>(order.size());
}

void Firing::settle_age() {
  bool ahead = false;
  for (ThreadState& thread : state_.threads) {
    if (state_.ended || thread.status == Status::off) {
      thread.carries = tag::none;
      continue;
    }
    const StepId step = thread.at();
    if (!watch_.counts[step]) thread.carries = tag::none;
    ahead = ahead || watch_.read_ahead[step];
  }
  if (!ahead) state_.condition_carries = tag::none;
  std::vector<std::uint8_t> order;
  const auto number = [&](std::uint8_t& carries) {
    if (carries >= tag::over) return;
    const auto known = std::find(order.begin(), order.end(), carries);
    if (known == order.end() && order.size() == tag::most) {
      outcome_.too_many = true;
      carries = tag::none;
    } else if (known == order.end()) {
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
  if (state_.ended) state_.pending.clear();  // the driver answers them when it closes
  std::vector<bool> carried(state_.pending.size());
  const auto mark = [&](std::uint8_t& carries) {
    if (state_.ended) carries = tag::none;
    if (carries != tag::none) carried[carries] = true;
  };
  for (ThreadState& thread : state_.threads) mark(thread.carries);
  for (SlotState& of : state_.slots) {
    mark(of.carries);
    mark(of.serving_carries);
  }
  std::vector<std::uint8_t> moved(state_.pending.size(), tag::none);
  std::vector<Pending> pending;
  bool after_lost = false;  // of several that are lost one after the other the first stands for all
  for (std::size_t i = 0; i < state_.pending.size(); ++i) {
    const bool outside = state_.pending[i] == Pending::outside;
    if (!carried[i] && (after_lost || outside)) continue;
    after_lost = !carried[i];
    const bool observed = !outside && state_.pending[i] != Pending::over;
    if (observed) outcome_.origin.push_back(pending_origin_[i]);
    moved[i] = static_cast<std::uint8_t>(pending.size());
    pending.push_back(!observed ? state_.pending[i] : carried[i] ? Pending::observed : Pending::lost);
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
