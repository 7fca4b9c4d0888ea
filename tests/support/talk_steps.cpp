// What a thread can do next, and the messages that go with it.
#include "tests/support/talk.hpp"

#include <algorithm>

namespace pal::test::talk {

bool Talk::available(const State& state, std::size_t channel) const {
  if (!is_device(network_.channels[channel].sender)) return state.slots[channel].full;
  const auto request = request_for(channel);
  return !request || !state.slots[*request].asked.empty();
}

/// The request that the next message of a channel answers, if any.
std::optional<std::size_t> Talk::answered(const State& state, std::size_t answer) const {
  const auto request = request_for(answer);
  if (!request) return std::nullopt;
  const Slot& of = state.slots[*request];
  for (std::size_t i = state.slots[answer].answers ? 1 : 0; i < of.asked.size(); ++i) {
    const bool taken = !of.full || i + 1 < of.asked.size();
    return taken ? std::optional(i) : std::nullopt;
  }
  return std::nullopt;
}

/// Withdraws the open requests, all or those of one thread. A request is removed from its slot, or its answer
/// is. Or the answer that is still to come is marked as not wanted.
void Talk::withdraw(State& state, std::size_t request, const std::optional<std::string>& owner) const {
  const auto back = answer_to(request);
  if (!back) return;
  Slot& slot = state.slots[request];
  Slot& answer = state.slots[*back];
  const bool device = is_device(network_.channels[request].receiver);
  std::vector<Asked> kept;
  for (std::size_t i = 0; i < slot.asked.size(); ++i) {
    Asked each = slot.asked[i];
    if (each.withdrawn || (owner && each.owner != *owner)) {
      kept.push_back(each);
    } else if (device) {
      continue;
    } else if (slot.full && i + 1 == slot.asked.size()) {
      slot.full = false;
    } else if (answer.answers && i == 0) {
      answer.full = answer.answers = false;
    } else {
      each.withdrawn = true;
      kept.push_back(each);
    }
  }
  slot.asked = kept;
}

void Talk::take(State& state, std::size_t channel) const {
  Slot& of = state.slots[channel];
  if (const auto request = request_for(channel)) {
    auto& asked = state.slots[*request].asked;
    const bool answers = of.answers || is_device(network_.channels[channel].sender);
    if (answers && !asked.empty()) asked.erase(asked.begin());
  }
  of.full = of.answers = false;
}

void Talk::done(Step step, std::size_t next, std::vector<Step>& result) const {
  std::vector<State> states;
  if (step.to.threads[at(step.thread)].finishing) {
    stop(std::move(step.to), step.thread, states);
  } else {
    go_to(std::move(step.to), step.thread, next, states);
  }
  for (auto& state : states) {
    Step one = step;
    one.to = std::move(state);
    result.push_back(std::move(one));
  }
}

bool Talk::value(const State& state, int thread, std::size_t condition) const {
  const auto& latched = state.threads[at(thread)].latched;
  const auto found = latched.find(condition);
  return found != latched.end() ? found->second : state.values[condition];
}

bool Talk::holds(const State& state, int thread, const pan::Guard& guard) const {
  switch (guard.kind) {
    case pan::Guard::Kind::equals:
      return value(state, thread, guard.condition.index()) == guard.value;
    case pan::Guard::Kind::negation:
      return !holds(state, thread, guard.terms[0]);
    case pan::Guard::Kind::all_of:
      for (const auto& term : guard.terms) {
        if (!holds(state, thread, term)) return false;
      }
      return true;
    case pan::Guard::Kind::any_of:
      for (const auto& term : guard.terms) {
        if (holds(state, thread, term)) return true;
      }
      return false;
  }
  return false;
}

std::vector<Step> Talk::steps(const State& state, int thread) const {
  std::vector<Step> result;
  const auto& self = state.threads[at(thread)];
  if (self.gone) return result;
  const auto& n = node(state, thread);
  const auto fresh = [&] {
    Step step;
    step.to = state;
    step.thread = thread;
    return step;
  };
  if (const auto* wait = std::get_if<pan::Wait>(&n.content)) {
    bool took = false;
    for (std::size_t i = 0; i < wait->channels.size(); ++i) {
      const auto channel = wait->channels[i].index();
      if (!available(state, channel)) continue;
      auto step = fresh();
      step.talk = true;
      step.take = channel;
      take(step.to, channel);
      done(std::move(step), n.out[i].index(), result);
      took = true;
    }
    if (self.finishing) {
      if (!took) done(fresh(), 0, result);
    } else if (wait->within) {
      auto step = fresh();
      step.timely = step.talk = true;
      for (const auto channel : wait->channels) {
        if (const auto request = request_for(channel.index())) withdraw(step.to, *request, std::nullopt);
      }
      done(std::move(step), n.out.back().index(), result);
    }
  } else if (const auto* send = std::get_if<pan::Send>(&n.content)) {
    const auto channel = send->channel.index();
    auto step = fresh();
    auto& slot = step.to.slots[channel];
    step.talk = true;
    step.put = channel;
    const bool to_device = is_device(network_.channels[channel].receiver);
    const auto answers = answered(state, channel);
    if (answers && state.slots[*request_for(channel)].asked[*answers].withdrawn) {
      auto& asked = step.to.slots[*request_for(channel)].asked;
      asked.erase(asked.begin() + static_cast<std::ptrdiff_t>(*answers));
      step.put.reset();
    } else if (slot.full) {
      if (!self.finishing) return result;
      step.put.reset();
      step.talk = false;
    } else {
      slot.full = !to_device;
      slot.answers = !to_device && answers;
      if (answer_to(channel)) slot.asked.push_back({self.name, false});
    }
    done(std::move(step), n.out.front().index(), result);
  } else if (std::holds_alternative<pan::Complete>(n.content)) {
    auto step = fresh();
    step.to = State{};
    step.to.ended = true;
    step.completes = true;
    result.push_back(std::move(step));
  } else if (const auto* set = std::get_if<pan::Set>(&n.content)) {
    for (const bool v : {false, true}) {
      if (set->value && *set->value != v) continue;
      auto step = fresh();
      step.to.values[set->condition.index()] = v;
      done(std::move(step), n.out.front().index(), result);
    }
  } else if (const auto* read = std::get_if<pan::Read>(&n.content)) {
    auto step = fresh();
    step.to.threads[at(thread)].latched[read->condition.index()] = state.values[read->condition.index()];
    done(std::move(step), n.out.front().index(), result);
  } else if (const auto* choose = std::get_if<pan::Choose>(&n.content)) {
    auto step = fresh();
    step.to.threads[at(thread)].latched.clear();
    for (std::size_t i = 0; i < choose->guards.size(); ++i) {
      if (!holds(state, thread, choose->guards[i])) continue;
      done(std::move(step), n.out[i].index(), result);
      return result;
    }
    step.to = State{};
    step.to.ended = true;
    result.push_back(std::move(step));
  } else if (const auto* until = std::get_if<pan::Until>(&n.content)) {
    auto step = fresh();
    step.to.threads[at(thread)].latched.clear();
    const bool out = holds(state, thread, *until->guard);
    done(std::move(step), out ? n.out.front().index() : n.mate.index(), result);
  } else if (std::holds_alternative<pan::Perform>(n.content)) {
    done(fresh(), n.out.front().index(), result);
  } else if (!std::holds_alternative<pan::End>(n.content) && !std::holds_alternative<pan::Join>(n.content)) {
    result.push_back(fresh());  // goes round for ever
  }
  return result;
}

}  // namespace pal::test::talk
