#include "pal/check/deadlock/moves.hpp"

#include <algorithm>
#include <utility>

namespace pal::frontend::deadlock {

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
  // Words of a request: its counts, and two owners in each of the others.
  std::size_t end = automata.threads.size();
  for (const auto& answer : automata.answer_of) {
    slots_.push_back(end);
    end += answer ? 1 + most_asked / 2 : 1;
  }
  requests_.resize(automata.threads.size());
  for (const auto& step : automata.steps) {
    if (step.kind != Step::Kind::send) continue;
    const auto channel = step.channels.front();
    if (!automata.answer_of[channel.index()]) continue;
    // A block that ends hands over what it has open.
    for (std::optional<std::size_t> t = step.thread; t; t = automata.threads[*t].parent) {
      auto& of = requests_[*t];
      if (std::find(of.begin(), of.end(), channel) == of.end()) of.push_back(channel);
    }
  }
  for (const auto& step : automata.steps) {
    auto& read = unknown_.emplace_back();
    for (const auto& guard : step.guards) conditions_of(guard, read);
    std::erase_if(read, [&](pan::ConditionId c) { return !automata.unknown[c.index()]; });
  }
  values_ = end;
  latches_ = values_ + bit_words_;
  words_ = latches_ + 2 * bit_words_ * automata.threads.size();
}

void Moves::Slot::push(std::size_t thread) {
  by[static_cast<std::size_t>(asked++)] = static_cast<int>(thread) + 1;
}

void Moves::Slot::erase(int at) {
  for (auto i = static_cast<std::size_t>(at); i + 1 < static_cast<std::size_t>(asked); ++i) by[i] = by[i + 1];
  by[static_cast<std::size_t>(--asked)] = 0;
}

int Moves::Slot::withdrawn() const {
  return static_cast<int>(std::count(by.begin(), by.begin() + asked, nobody));
}

Moves::Slot Moves::slot(const State& state, pan::ChannelId channel) const {
  const auto at = slots_[channel.index()];
  const auto first = static_cast<unsigned>(state[at]);
  Slot result{(first & 1) != 0, (first & 2) != 0, static_cast<int>(first >> 2), {}};
  for (std::size_t i = 0; i < static_cast<std::size_t>(result.asked); ++i) {
    result.by[i] = state[at + 1 + i / 2] >> (i % 2 == 0 ? 0 : 8) & 0xff;
  }
  return result;
}

void Moves::put_slot(State& state, pan::ChannelId channel, const Slot& slot) const {
  const auto at = slots_[channel.index()];
  state[at] = static_cast<char16_t>((slot.full ? 1 : 0) | (slot.answers ? 2 : 0) | slot.asked << 2);
  if (!automata_.answer_of[channel.index()]) return;
  for (std::size_t i = 0; i < slot.by.size(); i += 2) {
    state[at + 1 + i / 2] = static_cast<char16_t>(slot.by[i] | slot.by[i + 1] << 8);
  }
}

/// With more than a state can hold the oldest is forgotten; nothing is concluded then.
void Moves::ask(Slot& slot, std::size_t thread) const {
  overflowed_ = overflowed_ || slot.asked == most_asked || thread >= 0xff;
  if (slot.asked == most_asked) slot.erase(0);
  slot.push(std::min<std::size_t>(thread, 0xfe));
}

/// Of more withdrawn requests than are counted the rest is forgotten, if they stand together. If not it could
/// not be told which: nothing is concluded then.
void Moves::blur(Slot& slot) const {
  if (slot.withdrawn() <= withdrawn_) return;
  const auto end = slot.by.begin() + slot.asked;
  const auto first = std::find(slot.by.begin(), end, nobody);
  const auto behind = std::find_if(first, end, [](int owner) { return owner != nobody; });
  overflowed_ = overflowed_ || std::find(behind, end, nobody) != end;
  while (slot.withdrawn() > withdrawn_ + 1) slot.erase(static_cast<int>(first - slot.by.begin()));
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
  return (state[slots_[channel.index()]] & 1) != 0;
}

int Moves::open(const State& state, pan::ChannelId request) const {
  const auto of = slot(state, request);
  return of.asked - of.withdrawn();
}

bool Moves::blurred(const State& state) const {
  for (std::size_t c = 0; c < automata_.request_of.size(); ++c) {
    if (blurred(state, pan::ChannelId(c))) return true;
  }
  return false;
}

bool Moves::blurred(const State& state, pan::ChannelId answer) const {
  const auto& request = automata_.request_of[answer.index()];
  return request && asked(state, *request) > withdrawn_ && slot(state, *request).withdrawn() > withdrawn_;
}

int Moves::open(const State& state, pan::ChannelId request, std::size_t thread) const {
  const auto of = slot(state, request);
  const int owner = static_cast<int>(thread) + 1;
  return static_cast<int>(std::count(of.by.begin(), of.by.begin() + of.asked, owner));
}

bool Moves::answers(const State& state, pan::ChannelId answer, std::size_t thread) const {
  const auto& request = automata_.request_of[answer.index()];
  return request && slot(state, answer).answers &&
         slot(state, *request).by.front() == static_cast<int>(thread) + 1;
}

Threads Moves::owners(const State& state, pan::ChannelId request) const {
  Threads result;
  const auto of = slot(state, request);
  for (std::size_t i = 0; i < static_cast<std::size_t>(of.asked); ++i) {
    if (of.by[i] != nobody) result.set(static_cast<std::size_t>(of.by[i] - 1));
  }
  return result;
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
  for (auto i = before; i < result.size(); ++i) {
    forget(result[i].state);
    if (i == before) continue;
    auto alike = result[i].deed;
    alike.outcome = result[i - 1].deed.outcome;
    if (alike == result[i - 1].deed) result[i].deed.outcome = alike.outcome + 1;
  }
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
  if (!automata_.from_device[channel.index()]) return full(state, channel);
  const auto& request = automata_.request_of[channel.index()];
  return !request || asked(state, *request) > 0;  // an event may come at any time
}

void Moves::take(State& state, pan::ChannelId channel) const {
  auto of = slot(state, channel);
  const auto& request = automata_.request_of[channel.index()];
  if (request && (of.answers || automata_.from_device[channel.index()])) {
    auto asked = slot(state, *request);
    if (asked.asked > 0) asked.erase(0);
    put_slot(state, *request, asked);
  }
  of.full = of.answers = false;
  put_slot(state, channel, of);
}

/// The place of the request that the next message of the channel answers; -1: it answers none.
int Moves::answered_next(const State& state, pan::ChannelId answer) const {
  const auto& request = automata_.request_of[answer.index()];
  if (!request) return -1;
  const auto asked = slot(state, *request);
  const int next = slot(state, answer).answers ? 1 : 0;
  return next < asked.asked - (asked.full ? 1 : 0) ? next : -1;
}

/// All that is open of the request, or what belongs to the thread.
void Moves::withdraw(State& state, pan::ChannelId request, std::optional<std::size_t> thread) const {
  auto asked = slot(state, request);
  const auto& back = automata_.answer_of[request.index()];
  if (!back || asked.asked == 0) return;
  const bool device = automata_.to_device[request.index()];
  auto answer = slot(state, *back);
  for (int at = asked.asked - 1; at >= 0; --at) {
    auto& owner = asked.by[static_cast<std::size_t>(at)];
    if (owner == nobody || (thread && owner != static_cast<int>(*thread) + 1)) continue;
    if (device) {
      asked.erase(at);
    } else if (asked.full && at + 1 == asked.asked) {
      asked.full = false;
      asked.erase(at);
    } else if (answer.answers && at == 0) {
      answer.full = answer.answers = false;
      asked.erase(at);
    } else {
      owner = nobody;
    }
  }
  blur(asked);
  put_slot(state, request, asked);
  put_slot(state, *back, answer);
}

/// What a block that has ended has open is its parent's.
void Moves::hand_over(State& state, std::size_t block, std::size_t parent) const {
  for (const auto request : requests_[block]) {
    if (asked(state, request) == 0) continue;
    auto of = slot(state, request);
    std::replace(of.by.begin(), of.by.end(), static_cast<int>(block) + 1, static_cast<int>(parent) + 1);
    put_slot(state, request, of);
  }
}

State Moves::without_request(const State& state, pan::ChannelId request) const {
  State result = state;
  withdraw(result, request, std::nullopt);
  forget(result);
  return result;
}

void Moves::abandon(State& state, std::size_t thread) const {
  for (const auto request : requests_[thread]) {
    if (asked(state, request) > 0) withdraw(state, request, thread);
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
    if (!last && request && automata_.from_device[channel.index()] && slot(state, *request).asked > 1) {
      Move lost{{Deed::Kind::loses, thread, index, channel}, state, false, true};
      auto asked = slot(state, *request);
      asked.erase(1);  // the answer that came while the first one was there
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
    if (const auto& request = automata_.request_of[channel.index()])
      withdraw(move.state, *request, std::nullopt);
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
      if (of.asked == most) {
        move.deed.kind = Deed::Kind::loses;
        move.timely = true;
        of.erase(1);
      }
      ask(of, thread);
      put_slot(move.state, channel, of);
    }
    return go(std::move(move), step.next.front(), result);
  }
  const int answered = answered_next(state, channel);
  const auto& request = automata_.request_of[channel.index()];
  if (answered >= 0 && slot(state, *request).by[static_cast<std::size_t>(answered)] == nobody) {
    auto asked = slot(state, *request);
    move.deed.kind = Deed::Kind::discards;
    move.guessed = asked.withdrawn() > withdrawn_;
    if (move.guessed) go(move, step.next.front(), result);  // there are as many as before, or more
    asked.erase(answered);
    put_slot(move.state, *request, asked);
    return go(std::move(move), step.next.front(), result);
  }
  if (of.full) {
    if (!finishing(state, thread)) return;
    move.deed.kind = Deed::Kind::stops;
    return stop(std::move(move), thread, result);
  }
  of.full = true;
  of.answers = answered >= 0;
  if (asks) ask(of, thread);
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
  if (!known) return go({{Deed::Kind::sets, thread, index}, state, false, false}, step.next.front(), result);
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

/// Those of a test that may be taken, in the order of the text; the number of guards: no guard holds.
std::vector<std::size_t> Moves::branches(const State& state, std::size_t thread, std::size_t index) const {
  const auto& guards = automata_.steps[index].guards;
  const auto& unknown = unknown_[index];
  const bool too_many = unknown.size() > most_read_at_once;
  std::vector<bool> may(guards.size() + 1, too_many);
  for (std::size_t values = 0; !too_many && values >> unknown.size() == 0; ++values) {
    const auto read = [&](pan::ConditionId condition) {
      const auto at = std::find(unknown.begin(), unknown.end(), condition);
      if (at == unknown.end()) return reads(state, thread, condition);
      return (values >> (at - unknown.begin()) & 1) != 0;
    };
    const auto holds_now = [&](const pan::Guard& guard) { return holds(guard, read); };
    const auto first = std::find_if(guards.begin(), guards.end(), holds_now);
    may[static_cast<std::size_t>(first - guards.begin())] = true;
  }
  std::vector<std::size_t> result;
  for (std::size_t branch = 0; branch < may.size(); ++branch) {
    if (may[branch]) result.push_back(branch);
  }
  return result;
}

void Moves::test(const State& state, std::size_t thread, const Step& step, std::vector<Move>& result) const {
  const auto index = static_cast<std::size_t>(&step - automata_.steps.data());
  const auto found = branches(state, thread, index);
  for (const auto branch : found) {
    Move move{{Deed::Kind::finds, thread, index}, state, false, false, found.size() > 1};
    move.deed.branch = branch;
    for (std::size_t w = 0; w < 2 * bit_words_; ++w) move.state[latched(thread) + w] = 0;
    if (branch == step.guards.size() && !step.otherwise) {
      move.deed.kind = Deed::Kind::faults;
      move.ended = true;
      result.push_back(std::move(move));
    } else {
      go(std::move(move), step.next[branch], result);
    }
  }
}

}  // namespace pal::frontend::deadlock
