// What each kind of step does.
#include <algorithm>
#include <utility>

#include "pal/check/deadlock/moves.hpp"

namespace pal::check::deadlock {

void Moves::wait(const State& state, std::size_t thread, const Step& step, std::vector<Move>& result) const {
  const auto index = static_cast<std::size_t>(&step - automata_.steps.data());
  const bool last = finishing(state, thread);
  bool took = false;
  for (std::size_t i = 0; i < step.channels.size(); ++i) {
    const auto channel = step.channels[i];
    if (!can_take(state, channel)) continue;
    Move move{{Action::Kind::takes, thread, index, channel}, state, false, false};
    take(move.state, channel);
    go(std::move(move), step.next[i], result);
    took = true;
    const auto& request = automata_.request_of[channel.index()];
    if (!last && request && automata_.from_device[channel.index()] && slot(state, *request).asked > 1) {
      Move lost{{Action::Kind::loses, thread, index, channel}, state, false, true};
      auto asked = slot(state, *request);
      asked.erase(1);  // the answer that came while the first one was there
      put_slot(lost.state, *request, asked);
      result.push_back(std::move(lost));
    }
  }
  if (last && !took) {
    return stop({{Action::Kind::stops, thread, index}, state, false, false}, thread, result);
  }
  if (!step.gives_up || last) return;
  Move move{{Action::Kind::gives_up, thread, index, step.channels.front()}, state, false, true};
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
  Move move{{Action::Kind::sends, thread, index, channel}, state, false, false};
  if (automata_.to_device[channel.index()]) {
    if (asks) {
      // One in the slot, one being served, one answer not taken: with one more an answer is lost.
      constexpr int most = 3;
      if (of.asked == most) {
        move.action.kind = Action::Kind::loses;
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
  if (answered >= 0 && slot(state, *request).by[static_cast<std::size_t>(answered)] == no_thread) {
    auto asked = slot(state, *request);
    move.action.kind = Action::Kind::discards;
    move.guessed = asked.withdrawn() > withdrawn_;
    if (move.guessed) go(move, step.next.front(), result);  // there are as many as before, or more
    asked.erase(answered);
    put_slot(move.state, *request, asked);
    return go(std::move(move), step.next.front(), result);
  }
  if (of.full) {
    if (!finishing(state, thread)) return;
    move.action.kind = Action::Kind::stops;
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
    Move move{{Action::Kind::latches, thread, index}, state, false, false};
    if (known) {
      const bool value = bit(state, values_, *known);
      move.action.value = value;
      set_bit(move.state, latched(thread), *known, true);
      set_bit(move.state, latched(thread) + bit_words_, *known, value);
    }
    return go(std::move(move), step.next.front(), result);
  }
  if (!known)
    return go({{Action::Kind::sets, thread, index}, state, false, false}, step.next.front(), result);
  for (const bool value : {true, false}) {
    if (step.value && *step.value != value) continue;
    Move move{{Action::Kind::sets, thread, index, {}, value}, state, false, false};
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
  const bool too_many = unknown.size() > conditions::most_read_at_once;
  std::vector<bool> may(guards.size() + 1, too_many);
  for (std::size_t values = 0; !too_many && values >> unknown.size() == 0; ++values) {
    const auto read = [&](pan::ConditionId condition) {
      const auto at = std::find(unknown.begin(), unknown.end(), condition);
      if (at == unknown.end()) return reads(state, thread, condition);
      return (values >> (at - unknown.begin()) & 1) != 0;
    };
    const auto holds_now = [&](const pan::Guard& guard) { return conditions::holds(guard, read); };
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
    Move move{{Action::Kind::finds, thread, index}, state, false, false, found.size() > 1};
    move.action.branch = branch;
    for (std::size_t w = 0; w < 2 * bit_words_; ++w) move.state[latched(thread) + w] = 0;
    if (branch == step.guards.size() && !step.otherwise) {
      move.action.kind = Action::Kind::faults;
      move.ended = true;
      result.push_back(std::move(move));
    } else {
      go(std::move(move), step.next[branch], result);
    }
  }
}

}  // namespace pal::check::deadlock
