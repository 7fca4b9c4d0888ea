// What statements do at their effect.
#include "tests/support/runs/all_runs.hpp"

namespace pal::test {

using namespace pan;
using namespace runs;

bool AllRuns::look(int thread, int condition) {
  has_read(thread, condition);
  return (s_.conditions >> condition & 1U) != 0;
}

void AllRuns::mentioned(const Guard& guard, std::uint32_t& all) {
  if (guard.kind == Guard::Kind::equals) all |= 1U << guard.condition.index();
  for (const Guard& term : guard.terms) mentioned(term, all);
}

bool AllRuns::holds(const Guard& guard, std::uint32_t values) const {
  if (guard.kind == Guard::Kind::equals)
    return ((values >> guard.condition.index() & 1U) != 0) == guard.value;
  if (guard.kind == Guard::Kind::negation) return !holds(guard.terms.front(), values);
  int true_ones = 0;
  for (const Guard& term : guard.terms) true_ones += holds(term, values) ? 1 : 0;
  return guard.kind == Guard::Kind::any_of ? true_ones > 0
                                           : true_ones == static_cast<int>(guard.terms.size());
}

void AllRuns::effect(int thread) {
  Thread& of = s_.threads[ix(thread)];
  const Node& here = node(of);
  const auto& content = here.content;
  say(who(thread) + " does node " + std::to_string(of.at.back().second));
  if (const auto* wait = std::get_if<Wait>(&content)) {
    if (of.withdrawn) {
      if (of.cancelled) {
        stop(thread);
      } else {
        reach(thread);
      }
      return;
    }
    if (of.gives_up) {
      measure(thread);
      std::vector<int> freed;
      for (ChannelId channel : wait->channels) {
        if (request_of_[channel.index()] >= 0) withdraw(request_of_[channel.index()], std::nullopt, freed);
      }
      const std::size_t branch = wait->channels.size();
      admits(thread, freed);
      goes_on(thread, branch);
      return;
    }
    const int channel = wait->channels[ix(of.claim)].value;
    take(channel, thread);
    const auto branch = ix(of.claim);
    of.claim = -1;
    measure(thread);
    clear(channel);
    admits(thread, {channel});
    goes_on(thread, branch);
    return;
  }
  if (const auto* send = std::get_if<Send>(&content)) {
    if (discards(send->channel.value) || !s_.slots[send->channel.index()].full) {
      send_done(thread);
    } else if (of.cancelled) {
      stop(thread);
    } else {
      release(thread);
      of.status = Status::sending;
    }
    return;
  }
  if (const auto* complete = std::get_if<Complete>(&content)) {
    measure(thread);
    has_completed(complete->code);
    s_.ended = true;
    return;
  }
  if (const auto* set = std::get_if<Set>(&content)) {
    const bool value = set->value ? *set->value : decisions_->pick(2) == 1;
    const std::uint32_t bit = 1U << set->condition.index();
    s_.conditions = value ? s_.conditions | bit : s_.conditions & ~bit;
    has_set(thread, set->condition.value);
    measure(thread);
    proceed(thread, 0);
    return;
  }
  if (const auto* read = std::get_if<Read>(&content)) {
    const std::uint32_t bit = 1U << read->condition.index();
    of.latched |= bit;
    if (look(thread, read->condition.value)) {
      of.latched_true |= bit;
    } else {
      of.latched_true &= ~bit;
    }
    measure(thread);
    proceed(thread, 0);
    return;
  }
  if (std::holds_alternative<Perform>(content)) {
    measure(thread);
    proceed(thread, 0);
    return;
  }
  // A test.
  std::vector<Guard> guards;
  const auto* until = std::get_if<Until>(&content);
  if (until != nullptr) {
    guards.push_back(*until->guard);
  } else {
    guards = std::get<Choose>(content).guards;
  }
  std::uint32_t all = 0;
  for (const Guard& guard : guards) mentioned(guard, all);
  std::uint32_t values = of.latched & of.latched_true;
  for (int condition = 0; condition < 32; ++condition) {
    if ((all >> condition & 1U) == 0 || (of.latched >> condition & 1U) != 0) continue;
    if (look(thread, condition)) values |= 1U << condition;
  }
  of.latched = of.latched_true = 0;
  measure(thread);
  for (std::size_t i = 0; i < guards.size(); ++i) {
    if (!holds(guards[i], values)) continue;
    proceed(thread, i);
    return;
  }
  if (until != nullptr) {
    proceed(thread, 1);
  } else {
    has_completed(error_code());
    s_.ended = true;
  }
}

/// The channels are there for senders that are blocked. A statement that a cancelled block finishes has its
/// whole effect before it stops.
void AllRuns::admits(int thread, std::vector<int> channels) {
  std::erase_if(channels, [this](int channel) { return !somebody_sends(channel); });
  if (s_.threads[ix(thread)].cancelled) {
    any_order(std::move(channels), [this](int channel) { emptied(channel); });
    return;
  }
  for (int channel : channels) later([this, channel] { emptied(channel); });
}

/// The effect is over: the thread goes on to what follows, or stops if it was cancelled.
void AllRuns::proceed(int thread, std::size_t out) {
  if (s_.ended) return;
  has_done(thread);
  if (s_.threads[ix(thread)].cancelled) {
    stop(thread);
    return;
  }
  Thread& of = s_.threads[ix(thread)];
  if (std::holds_alternative<Fork>(node(of).content)) {
    of.at.back().second = node(of).mate.value;
  } else {
    leave_node(thread, out);
  }
  walk_on(thread);
}

}  // namespace pal::test
