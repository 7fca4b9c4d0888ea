#include "pal/check/deadlock/reduction.hpp"

#include <algorithm>

namespace pal::frontend::deadlock {

Reduction::Reduction(const Automata& automata, const Moves& moves) : automata_(automata), moves_(moves) {
  const auto channels = automata.request_of.size();
  const auto resources = 4 * channels + 2 * automata.bits;
  answer_of_.assign(channels, channels);
  for (std::size_t c = 0; c < channels; ++c) {
    if (automata.request_of[c]) answer_of_[automata.request_of[c]->index()] = c;
  }
  for (const auto& thread : automata.threads) {
    uses_.emplace_back(resources, false);
    cancellable_.push_back(thread.parent && (!thread.can_end || cancellable_[*thread.parent]));
  }
  for (const auto& step : automata.steps) {
    use_step(step, uses_[step.thread]);
    if (cancellable_[step.thread]) use_request(step, uses_[step.thread]);
  }
  // Blocks have greater numbers than their parents, who may start them.
  for (auto t = automata.threads.size(); t-- > 0;) {
    for (const auto block : automata.threads[t].children) {
      for (std::size_t r = 0; r < resources; ++r) uses_[t][r] = uses_[t][r] || uses_[block][r];
    }
  }
  users_.resize(resources);
  for (std::size_t t = 0; t < uses_.size(); ++t) {
    for (std::size_t r = 0; r < resources; ++r) {
      if (uses_[t][r]) users_[r].push_back(t);
    }
  }
}

std::size_t Reduction::resource(Use use, std::size_t index) const {
  const auto channels = automata_.request_of.size();
  switch (use) {
    case Use::put:
      return 4 * index;
    case Use::take:
      return 4 * index + 1;
    case Use::withdraw:
      return 4 * index + 2;
    case Use::device:
      return 4 * index + 3;
    case Use::read:
      return 4 * channels + 2 * index;
    case Use::write:
      return 4 * channels + 2 * index + 1;
  }
  return 0;
}

void Reduction::use_step(const Step& step, std::vector<bool>& uses) const {
  for (const auto channel : step.channels) {
    const auto& request = automata_.request_of[channel.index()];
    if (step.kind == Step::Kind::send) {
      uses[resource(automata_.to_device[channel.index()] ? Use::device : Use::put, channel.index())] = true;
    } else if (automata_.from_device[channel.index()]) {
      if (request) uses[resource(Use::device, request->index())] = true;
    } else {
      uses[resource(Use::take, channel.index())] = true;
      if (step.gives_up && request) uses[resource(Use::withdraw, request->index())] = true;
    }
  }
  const auto known = [&](pan::ConditionId c) { return automata_.bit[c.index()]; };
  if (step.kind == Step::Kind::set) uses[resource(Use::write, *known(step.condition))] = true;
  if (step.kind == Step::Kind::latch && known(step.condition))
    uses[resource(Use::read, *known(step.condition))] = true;
  std::vector<pan::ConditionId> conditions;
  for (const auto& guard : step.guards) conditions_of(guard, conditions);
  for (const auto condition : conditions) {
    if (const auto bit = known(condition)) uses[resource(Use::read, *bit)] = true;
  }
}

/// A thread that can be cancelled withdraws what it asked for.
void Reduction::use_request(const Step& step, std::vector<bool>& uses) const {
  if (step.kind != Step::Kind::send) return;
  const auto channel = step.channels.front().index();
  uses[resource(automata_.to_device[channel] ? Use::device : Use::withdraw, channel)] = true;
}

bool Reduction::is_above(std::size_t above, std::size_t thread) const {
  for (auto at = automata_.threads[thread].parent; at; at = automata_.threads[*at].parent) {
    if (*at == above) return true;
  }
  return false;
}

std::size_t Reduction::root_of(std::size_t thread) const {
  while (automata_.threads[thread].parent) thread = *automata_.threads[thread].parent;
  return thread;
}

/// Moves that end the skill, or the work of other blocks.
bool Reduction::concerns_all(const State& state, std::size_t thread, const std::vector<Move>& moves) const {
  if (moves_.finishing(state, thread)) return true;
  for (const auto& move : moves) {
    if (move.ended) return true;
    for (std::optional<std::size_t> at = thread; at; at = automata_.threads[*at].parent) {
      const auto& parent = automata_.threads[*at].parent;
      if (!parent || moves_.active(move.state, *at)) break;
      for (const auto sibling : automata_.threads[*parent].children) {
        if (moves_.active(state, sibling) && !automata_.threads[sibling].can_end) return true;
      }
    }
  }
  return false;
}

/// What others must not do while this thread is where it is.
void Reduction::disturbing(const State& state, std::size_t thread,
                           std::vector<std::size_t>& resources) const {
  const auto& step = moves_.at(state, thread);
  const auto add = [&](Use use, std::size_t index) { resources.push_back(resource(use, index)); };
  for (const auto channel : step.channels) {
    const auto c = channel.index();
    const auto& request = automata_.request_of[c];
    if (step.kind == Step::Kind::send) {
      if (automata_.to_device[c]) {
        add(Use::device, c);
        continue;
      }
      add(Use::put, c);
      add(Use::withdraw, c);
      if (answer_of_[c] < answer_of_.size()) add(Use::take, answer_of_[c]);
      if (moves_.full(state, channel)) {
        add(Use::take, c);
        if (request) add(Use::withdraw, request->index());
      }
      continue;
    }
    if (automata_.from_device[c]) {
      if (request) add(Use::device, request->index());
      continue;
    }
    if (moves_.full(state, channel)) {
      add(Use::withdraw, c);
      if (request) add(Use::withdraw, request->index());
    } else {
      add(Use::put, c);
    }
    add(Use::take, c);
    if (request) {
      add(Use::put, request->index());
      add(Use::withdraw, request->index());
      if (step.gives_up) add(Use::take, request->index());
    }
  }
  std::vector<pan::ConditionId> conditions;
  if (step.kind == Step::Kind::set || step.kind == Step::Kind::latch) conditions.push_back(step.condition);
  for (const auto& guard : step.guards) conditions_of(guard, conditions);
  for (const auto condition : conditions) {
    const auto& bit = automata_.bit[condition.index()];
    if (!bit) continue;
    add(Use::write, *bit);
    if (step.kind == Step::Kind::set) add(Use::read, *bit);
  }
}

/// The least set of threads with `seed` that the others leave alone. False: it is all of them.
bool Reduction::close(const State& state, const Enabled& enabled, std::size_t seed,
                      std::vector<bool>& in) const {
  std::vector<std::size_t> open{seed};
  in[seed] = true;
  const auto enter = [&](std::size_t thread) {
    if (in[thread]) return;
    in[thread] = true;
    open.push_back(thread);
  };
  std::vector<std::size_t> resources;
  while (!open.empty()) {
    const auto thread = open.back();
    open.pop_back();
    if (!moves_.active(state, thread)) continue;
    if (concerns_all(state, thread, enabled[thread])) return false;
    if (cancellable_[thread] || moves_.at(state, thread).kind == Step::Kind::join) {
      for (std::size_t other = 0; other < automata_.threads.size(); ++other) {
        if (root_of(other) == root_of(thread) && !is_above(other, thread)) enter(other);
      }
    }
    resources.clear();
    disturbing(state, thread, resources);
    for (const auto resource : resources) {
      for (const auto user : users_[resource]) {
        // Those above wait for this thread.
        if (user != thread && moves_.active(state, user) && !is_above(user, thread)) enter(user);
      }
    }
  }
  return true;
}

std::vector<std::size_t> Reduction::choose(const State& state, const Enabled& enabled) const {
  std::vector<std::size_t> best;
  for (std::size_t t = 0; t < enabled.size(); ++t) {
    if (!enabled[t].empty()) best.push_back(t);
  }
  if (best.size() < 2) return best;
  const auto candidates = best;
  for (const auto seed : candidates) {
    std::vector<bool> in(enabled.size(), false);
    if (!close(state, enabled, seed, in)) continue;
    std::vector<std::size_t> chosen;
    for (const auto t : candidates) {
      if (in[t]) chosen.push_back(t);
    }
    if (chosen.size() < best.size()) best = std::move(chosen);
    if (best.size() == 1) break;
  }
  return best;
}

}  // namespace pal::frontend::deadlock
