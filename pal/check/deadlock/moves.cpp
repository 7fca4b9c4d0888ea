#include "pal/check/deadlock/moves.hpp"

#include <algorithm>
#include <utility>

namespace pal::check::deadlock {

bool is_talk(const Action& action) {
  switch (action.kind) {
    case Action::Kind::takes:
    case Action::Kind::sends:
    case Action::Kind::discards:
    case Action::Kind::gives_up:
    case Action::Kind::loses:
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
  lay_out();
  find_requests();
  for (const auto& step : automata.steps) {
    forks_ += step.kind == Step::Kind::fork ? 1 : 0;
    auto& read = unknown_.emplace_back();
    for (const auto& guard : step.guards) conditions::conditions_of(guard, read);
    std::erase_if(read, [&](pan::ConditionId c) { return !automata.unknown[c.index()]; });
  }
}

/// Of a request: a word with its counts, and two owners in each of the others.
void Moves::lay_out() {
  bit_words_ = (automata_.bits + 15) / 16;
  values_ = automata_.threads.size();
  for (const auto& answer : automata_.answer_of) {
    slots_.push_back(values_);
    values_ += answer ? 1 + most_asked / 2 : 1;
  }
  latches_ = values_ + bit_words_;
  words_ = latches_ + 2 * bit_words_ * automata_.threads.size();
}

/// A block that ends hands over what it has open.
void Moves::find_requests() {
  requests_.resize(automata_.threads.size());
  for (const auto& step : automata_.steps) {
    if (step.kind != Step::Kind::send) continue;
    const auto channel = step.channels.front();
    if (!automata_.answer_of[channel.index()]) continue;
    for (std::optional<std::size_t> t = step.thread; t; t = automata_.threads[*t].parent) {
      auto& of = requests_[*t];
      if (std::find(of.begin(), of.end(), channel) == of.end()) of.push_back(channel);
    }
  }
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
    auto alike = result[i].action;
    alike.outcome = result[i - 1].action.outcome;
    if (alike == result[i - 1].action) result[i].action.outcome = alike.outcome + 1;
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
      Move move{{Action::Kind::completes, thread, static_cast<std::size_t>(&step - automata_.steps.data())},
                state,
                true,
                false};
      result.push_back(std::move(move));
      return;
    }
    case Step::Kind::work:
      return go({{Action::Kind::works, thread, static_cast<std::size_t>(&step - automata_.steps.data())},
                 state,
                 false,
                 false},
                step.next.front(), result);
    case Step::Kind::spin:
    case Step::Kind::enter:
    case Step::Kind::fork:
      result.push_back(
          {{Action::Kind::spins, thread, static_cast<std::size_t>(&step - automata_.steps.data())},
           state,
           false,
           false});
      return;
    case Step::Kind::join:
    case Step::Kind::end:
      return;
  }
}

}  // namespace pal::check::deadlock
