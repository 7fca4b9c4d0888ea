#include "pal/check/deadlock/moves.hpp"

#include <algorithm>
#include <utility>

namespace pal::frontend::deadlock {

namespace {

constexpr int most_open = 7;

}  // namespace

bool is_talk(const Deed& deed) {
  switch (deed.kind) {
    case Deed::Kind::takes:
    case Deed::Kind::sends:
    case Deed::Kind::discards:
    case Deed::Kind::gives_up:
    case Deed::Kind::loses:
      return true;
    default:
      return false;
  }
}

Moves::Moves(const Automata& automata, int withdrawn)
    : automata_(automata),
      withdrawn_(withdrawn),
      to_be_read_(conditions_to_be_read(automata)),
      latches_to_be_read_(latches_to_be_read(automata)) {
  bit_words_ = (automata.bits + 15) / 16;
  channels_ = automata.threads.size();
  values_ = channels_ + 2 * automata.request_of.size();
  latches_ = values_ + bit_words_;
  words_ = latches_ + 2 * bit_words_ * automata.threads.size();
}

Moves::Slot Moves::slot(const State& state, pan::ChannelId channel) const {
  const auto at = channels_ + 2 * channel.index();
  const auto counts = static_cast<unsigned>(state[at]);
  return {(counts & 1) != 0, static_cast<int>(counts >> 1 & 7), static_cast<int>(counts >> 4 & 7),
          static_cast<int>(state[at + 1])};
}

void Moves::put_slot(State& state, pan::ChannelId channel, Slot slot) const {
  if (slot.open > most_open) overflowed_ = true;
  slot.open = std::min(slot.open, most_open);
  slot.unwanted = std::min(slot.unwanted, withdrawn_ + 1);
  if (slot.open == 0) slot.owner = 0;
  const auto at = channels_ + 2 * channel.index();
  state[at] = static_cast<char16_t>((slot.full ? 1 : 0) | slot.open << 1 | slot.unwanted << 4);
  state[at + 1] = static_cast<char16_t>(slot.owner);
}

bool Moves::bit(const State& state, std::size_t base, std::size_t index) const {
  return (state[base + index / 16] >> index % 16 & 1) != 0;
}

void Moves::set_bit(State& state, std::size_t base, std::size_t index, bool value) const {
  const auto mask = static_cast<char16_t>(1U << index % 16);
  auto& in = state[base + index / 16];
  in = static_cast<char16_t>(value ? in | mask : in & ~mask);
}

std::size_t Moves::latched(std::size_t thread) const {
  return latches_ + 2 * bit_words_ * thread;
}

const Step& Moves::at(const State& state, std::size_t thread) const {
  return automata_.steps[static_cast<std::size_t>(state[thread] & ~finishing_flag)];
}

bool Moves::finishing(const State& state, std::size_t thread) const {
  return active(state, thread) && (state[thread] & finishing_flag) != 0;
}

bool Moves::full(const State& state, pan::ChannelId channel) const {
  return slot(state, channel).full;
}

int Moves::open(const State& state, pan::ChannelId request) const {
  return slot(state, request).open;
}

bool Moves::blurred(const State& state) const {
  for (std::size_t c = 0; c < automata_.request_of.size(); ++c) {
    if (blurred(state, pan::ChannelId(c))) return true;
  }
  return false;
}

bool Moves::blurred(const State& state, pan::ChannelId answer) const {
  return slot(state, answer).unwanted > withdrawn_;
}

std::optional<std::size_t> Moves::owner(const State& state, pan::ChannelId request) const {
  const auto of = slot(state, request);
  if (of.open == 0 || of.owner == 0) return std::nullopt;
  return static_cast<std::size_t>(of.owner - 1);
}

State Moves::first() const {
  State state(words_, 0);
  for (std::size_t t = 0; t < automata_.threads.size(); ++t) state[t] = nowhere;
  for (std::size_t t = 0; t < automata_.threads.size(); ++t) {
    if (automata_.threads[t].parent) continue;
    std::vector<Move> begun;
    arrive({{}, state, false, false}, t, automata_.threads[t].first, begun);
    state = std::move(begun.front().state);
  }
  forget(state);
  return state;
}

void Moves::of(const State& state, std::size_t thread, std::vector<Move>& result) const {
  const auto before = result.size();
  steps_of(state, thread, result);
  for (auto i = before; i < result.size(); ++i) forget(result[i].state);
}

void Moves::forget(State& state) const {
  for (std::size_t w = 0; w < bit_words_; ++w) {
    unsigned needed = 0;
    for (std::size_t t = 0; t < automata_.threads.size(); ++t) {
      if (!active(state, t)) continue;
      const auto step = static_cast<std::size_t>(state[t] & ~finishing_flag);
      needed |= to_be_read_.word(step, w);
      const auto mask = static_cast<unsigned>(latches_to_be_read_.word(step, w));
      auto& known = state[latched(t) + w];
      known = static_cast<char16_t>(known & mask);
      auto& value = state[latched(t) + bit_words_ + w];
      value = static_cast<char16_t>(value & known);
    }
    auto& values = state[values_ + w];
    values = static_cast<char16_t>(values & needed);
  }
}

void Moves::steps_of(const State& state, std::size_t thread, std::vector<Move>& result) const {
  if (!active(state, thread)) return;
  const auto& step = at(state, thread);
  switch (step.kind) {
    case Step::Kind::wait:
      return wait(state, thread, step, result);
    case Step::Kind::send:
      return send(state, thread, step, result);
    case Step::Kind::set:
    case Step::Kind::latch:
      return set(state, thread, step, result);
    case Step::Kind::test:
      return test(state, thread, step, result);
    case Step::Kind::complete: {
      Move move{{Deed::Kind::completes, thread, static_cast<std::size_t>(&step - automata_.steps.data())},
                state,
                true,
                false};
      result.push_back(std::move(move));
      return;
    }
    case Step::Kind::spin:
    case Step::Kind::enter:
      result.push_back({{Deed::Kind::spins, thread, static_cast<std::size_t>(&step - automata_.steps.data())},
                        state,
                        false,
                        false});
      return;
    case Step::Kind::fork:
    case Step::Kind::join:
    case Step::Kind::end:
      return;
  }
}

bool Moves::can_take(const State& state, pan::ChannelId channel) const {
  if (!automata_.from_device[channel.index()]) return slot(state, channel).full;
  const auto& request = automata_.request_of[channel.index()];
  return !request || slot(state, *request).open > 0;  // an event may come at any time
}

void Moves::take(State& state, pan::ChannelId channel) const {
  auto of = slot(state, channel);
  of.full = false;
  put_slot(state, channel, of);
  if (const auto& request = automata_.request_of[channel.index()]) {
    auto asked = slot(state, *request);
    if (asked.open > 0) --asked.open;
    put_slot(state, *request, asked);
  }
}

void Moves::withdraw(State& state, pan::ChannelId request) const {
  auto asked = slot(state, request);
  if (automata_.to_device[request.index()]) {
    asked.open = 0;
    return put_slot(state, request, asked);
  }
  const auto& back = automata_.answer_of[request.index()];
  if (!back) return;
  auto answer = slot(state, *back);
  for (; asked.open > 0; --asked.open) {
    if (asked.full) {
      asked.full = false;
    } else if (answer.full) {
      answer.full = false;
    } else {
      ++answer.unwanted;
    }
  }
  put_slot(state, request, asked);
  put_slot(state, *back, answer);
}

State Moves::without_request(const State& state, pan::ChannelId request) const {
  State result = state;
  withdraw(result, request);
  forget(result);
  return result;
}

void Moves::abandon(State& state, std::size_t thread) const {
  for (std::size_t c = 0; c < automata_.request_of.size(); ++c) {
    const auto of = slot(state, pan::ChannelId(c));
    if (of.open > 0 && of.owner == static_cast<int>(thread) + 1) withdraw(state, pan::ChannelId(c));
  }
}

void Moves::wait(const State& state, std::size_t thread, const Step& step, std::vector<Move>& result) const {
  const auto index = static_cast<std::size_t>(&step - automata_.steps.data());
  const bool last = finishing(state, thread);
  bool took = false;
  for (std::size_t i = 0; i < step.channels.size(); ++i) {
    const auto channel = step.channels[i];
    if (!can_take(state, channel)) continue;
    Move move{{Deed::Kind::takes, thread, index, channel}, state, false, false};
    take(move.state, channel);
    go(std::move(move), step.next[i], result);
    took = true;
    const auto& request = automata_.request_of[channel.index()];
    if (!last && request && automata_.from_device[channel.index()] && slot(state, *request).open > 1) {
      Move lost{{Deed::Kind::loses, thread, index, channel}, state, false, true};
      auto asked = slot(state, *request);
      --asked.open;
      put_slot(lost.state, *request, asked);
      result.push_back(std::move(lost));
    }
  }
  if (last && !took) {
    return stop({{Deed::Kind::stops, thread, index}, state, false, false}, thread, result);
  }
  if (!step.gives_up || last) return;
  Move move{{Deed::Kind::gives_up, thread, index, step.channels.front()}, state, false, true};
  for (const auto channel : step.channels) {
    if (const auto& request = automata_.request_of[channel.index()]) withdraw(move.state, *request);
  }
  go(std::move(move), step.next.back(), result);
}

void Moves::send(const State& state, std::size_t thread, const Step& step, std::vector<Move>& result) const {
  const auto index = static_cast<std::size_t>(&step - automata_.steps.data());
  const auto channel = step.channels.front();
  auto of = slot(state, channel);
  const bool asks = automata_.answer_of[channel.index()].has_value();
  Move move{{Deed::Kind::sends, thread, index, channel}, state, false, false};
  if (automata_.to_device[channel.index()]) {
    if (asks) {
      // One in the slot, one being served, one answer not taken: with one more an answer is lost.
      constexpr int most = 3;
      if (of.open == most) {
        move.deed.kind = Deed::Kind::loses;
        move.timely = true;
      }
      of.open = std::min(of.open + 1, most);
      of.owner = static_cast<int>(thread) + 1;
      put_slot(move.state, channel, of);
    }
    return go(std::move(move), step.next.front(), result);
  }
  if (of.unwanted > 0) {
    move.deed.kind = Deed::Kind::discards;
    move.guessed = of.unwanted > withdrawn_;
    if (move.guessed) go(move, step.next.front(), result);  // there are as many as before, or more
    --of.unwanted;
    put_slot(move.state, channel, of);
    return go(std::move(move), step.next.front(), result);
  }
  if (of.full) {
    if (!finishing(state, thread)) return;
    move.deed.kind = Deed::Kind::stops;
    return stop(std::move(move), thread, result);
  }
  of.full = true;
  if (asks) {
    ++of.open;
    of.owner = static_cast<int>(thread) + 1;
  }
  put_slot(move.state, channel, of);
  go(std::move(move), step.next.front(), result);
}

/// Also RPC.
void Moves::set(const State& state, std::size_t thread, const Step& step, std::vector<Move>& result) const {
  const auto index = static_cast<std::size_t>(&step - automata_.steps.data());
  const auto& known = automata_.bit[step.condition.index()];
  if (step.kind == Step::Kind::latch) {
    Move move{{Deed::Kind::latches, thread, index}, state, false, false};
    if (known) {
      const bool value = bit(state, values_, *known);
      move.deed.value = value;
      set_bit(move.state, latched(thread), *known, true);
      set_bit(move.state, latched(thread) + bit_words_, *known, value);
    }
    return go(std::move(move), step.next.front(), result);
  }
  for (const bool value : {true, false}) {
    if (step.value && *step.value != value) continue;
    Move move{{Deed::Kind::sets, thread, index, {}, value}, state, false, false};
    set_bit(move.state, values_, *known, value);
    go(std::move(move), step.next.front(), result);
  }
}

bool Moves::reads(const State& state, std::size_t thread, pan::ConditionId condition) const {
  const auto& known = automata_.bit[condition.index()];
  if (!known) return false;
  if (bit(state, latched(thread), *known)) return bit(state, latched(thread) + bit_words_, *known);
  return bit(state, values_, *known);
}

void Moves::test(const State& state, std::size_t thread, const Step& step, std::vector<Move>& result) const {
  const auto index = static_cast<std::size_t>(&step - automata_.steps.data());
  const auto read = [&](pan::ConditionId condition) { return reads(state, thread, condition); };
  std::size_t branch = 0;
  while (branch < step.guards.size() && !holds(step.guards[branch], read)) ++branch;
  Move move{{Deed::Kind::finds, thread, index}, state, false, false};
  move.deed.branch = branch;
  for (std::size_t w = 0; w < 2 * bit_words_; ++w) move.state[latched(thread) + w] = 0;
  if (branch == step.guards.size() && !step.otherwise) {
    move.deed.kind = Deed::Kind::faults;
    move.ended = true;
    result.push_back(std::move(move));
    return;
  }
  go(std::move(move), step.next[branch], result);
}

}  // namespace pal::frontend::deadlock
