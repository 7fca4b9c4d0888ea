// What is in the slots: messages, and the requests that are open or withdrawn and yet to be answered.
#include <algorithm>

#include "pal/check/deadlock/moves.hpp"

namespace pal::check::deadlock {

void Moves::Slot::push(std::size_t thread) {
  by[static_cast<std::size_t>(asked++)] = static_cast<int>(thread) + 1;
}

void Moves::Slot::erase(int at) {
  for (auto i = static_cast<std::size_t>(at); i + 1 < static_cast<std::size_t>(asked); ++i) by[i] = by[i + 1];
  by[static_cast<std::size_t>(--asked)] = 0;
}

int Moves::Slot::withdrawn() const {
  return static_cast<int>(std::count(by.begin(), by.begin() + asked, no_thread));
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
  const auto first = std::find(slot.by.begin(), end, no_thread);
  const auto behind = std::find_if(first, end, [](int owner) { return owner != no_thread; });
  overflowed_ = overflowed_ || std::find(behind, end, no_thread) != end;
  while (slot.withdrawn() > withdrawn_ + 1) slot.erase(static_cast<int>(first - slot.by.begin()));
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
    if (of.by[i] != no_thread) result.set(static_cast<std::size_t>(of.by[i] - 1));
  }
  return result;
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
    if (owner == no_thread || (thread && owner != static_cast<int>(*thread) + 1)) continue;
    if (device) {
      asked.erase(at);
    } else if (asked.full && at + 1 == asked.asked) {
      asked.full = false;
      asked.erase(at);
    } else if (answer.answers && at == 0) {
      answer.full = answer.answers = false;
      asked.erase(at);
    } else {
      owner = no_thread;
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

}  // namespace pal::check::deadlock
