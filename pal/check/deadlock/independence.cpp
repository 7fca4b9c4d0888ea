#include "pal/check/deadlock/independence.hpp"

#include <algorithm>
#include <utility>

namespace pal::check::deadlock {

namespace {

std::size_t resources(const Automata& automata) {
  return 4 * automata.request_of.size() + 2 * automata.bits + 1;
}

}  // namespace

Independence::Independence(const Automata& automata, const Moves& moves, std::vector<bool> observed,
                           bool absorb)
    : automata_(automata),
      moves_(moves),
      observed_(std::move(observed)),
      absorb_(absorb),
      future_(automata.steps.size(), resources(automata)),
      users_(resources(automata)) {
  for (const auto& thread : automata.threads) {
    Threads above;
    Threads cancellers;
    if (thread.parent) {
      above = above_[*thread.parent];
      above.set(*thread.parent);
      cancellers = cancellers_[*thread.parent];
      if (!thread.can_end) {
        for (const auto sibling : automata.threads[*thread.parent].children) {
          if (automata.threads[sibling].can_end) cancellers.set(sibling);
        }
      }
    }
    above_.push_back(above);
    cancellers_.push_back(cancellers);
  }
  // The blocks of one whose end cancels may keep it from ending.
  for (auto& cancellers : cancellers_) {
    for (std::size_t t = 0; t < automata.threads.size(); ++t) {
      if ((above_[t] & cancellers).any()) cancellers.set(t);
    }
  }
  for (std::size_t i = 0; i < automata.steps.size(); ++i) enter_uses(i);
  close_over_future(automata, future_);
  for (std::size_t t = 0; t < automata.threads.size(); ++t) {
    for (std::size_t r = 0; r < users_.size(); ++r) {
      if (future_.has(automata.threads[t].first, r)) users_[r].set(t);
    }
  }
}

std::size_t Independence::resource(Use use, std::size_t index) const {
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
    case Use::complete:
      return 4 * channels + 2 * automata_.bits;
  }
  return 0;
}

void Independence::enter_uses(std::size_t index) {
  const auto& step = automata_.steps[index];
  const auto add = [&](Use use, std::size_t what) { future_.add(index, resource(use, what)); };
  const bool cancellable = cancellers_[step.thread].any();
  for (const auto channel : step.channels) {
    const auto c = channel.index();
    const auto& request = automata_.request_of[c];
    if (step.kind == Step::Kind::send) {
      add(automata_.to_device[c] ? Use::device : Use::put, c);
      // A thread that can be cancelled withdraws what it asked for.
      if (cancellable && !automata_.to_device[c]) add(Use::withdraw, c);
    } else if (automata_.from_device[c]) {
      if (request) add(Use::device, request->index());
    } else {
      add(Use::take, c);
      if (step.gives_up && request) add(Use::withdraw, request->index());
    }
  }
  if (step.kind == Step::Kind::complete) add(Use::complete, 0);
  const auto bit = [&](pan::ConditionId c) { return automata_.bit[c.index()]; };
  if (step.kind == Step::Kind::set && bit(step.condition)) add(Use::write, *bit(step.condition));
  if (step.kind == Step::Kind::latch && bit(step.condition)) add(Use::read, *bit(step.condition));
  std::vector<pan::ConditionId> conditions;
  for (const auto& guard : step.guards) conditions::conditions_of(guard, conditions);
  for (const auto condition : conditions) {
    if (bit(condition)) add(Use::read, *bit(condition));
  }
}

std::size_t Independence::step_of(const State& state, std::size_t thread) const {
  return static_cast<std::size_t>(&moves_.at(state, thread) - automata_.steps.data());
}

/// Moves that end the skill, or the work of other blocks.
bool Independence::concerns_all(const State& state, std::size_t thread,
                                const std::vector<Move>& moves) const {
  for (const auto& move : moves) {
    if (move.ended || move.cancels) return true;
  }
  // When it stops it withdraws what it asked for, and so do those above that stop with it.
  for (std::size_t t = 0; t < automata_.threads.size(); ++t) {
    if ((t != thread && !above_[thread].test(t)) || !moves_.finishing(state, t)) continue;
    for (std::size_t c = 0; c < automata_.request_of.size(); ++c) {
      if (moves_.open(state, pan::ChannelId(c), t) > 0) return true;
    }
  }
  return false;
}

/// Whether the block is cancelled before all of these moves or after them, the result is the same. The
/// requests that it has open, and their answers, are withdrawn.
bool Independence::undone_by_cancelling(const State& state, std::size_t thread,
                                        const std::vector<Move>& moves) const {
  const auto& step = moves_.at(state, thread);
  if (moves_.finishing(state, thread) || step.gives_up) return false;
  for (const auto& move : moves) {
    if (move.cancels) return false;
    for (std::size_t other = 0; other < automata_.threads.size(); ++other) {
      if (other != thread && state[other] != move.state[other]) return false;
    }
    if (move.state[thread] == Moves::nowhere) return false;
    const auto channel = move.action.channel;
    if (move.action.kind == Action::Kind::sends) {
      const bool asks = automata_.answer_of[channel.index()] && !automata_.to_device[channel.index()];
      if (!asks) return false;
    } else if (move.action.kind == Action::Kind::takes) {
      const auto& request = automata_.request_of[channel.index()];
      if (!request || automata_.from_device[channel.index()] || !moves_.answers(state, channel, thread))
        return false;
    } else if (move.action.kind != Action::Kind::latches && move.action.kind != Action::Kind::finds &&
               move.action.kind != Action::Kind::works) {
      return false;
    }
  }
  return true;
}

void Independence::add_users(const State& state, Use use, std::size_t index, std::size_t thread,
                             Threads& result) const {
  const auto what = resource(use, index);
  for (std::size_t user = 0; user < automata_.threads.size(); ++user) {
    // Those above wait for this thread.
    if (!users_[what].test(user) || user == thread || above_[thread].test(user)) continue;
    if (moves_.active(state, user) && future_.has(step_of(state, user), what)) result.set(user);
  }
}

/// Those that may withdraw the request: its sender by giving up, or a thread that may cancel its sender.
void Independence::add_withdrawers(const State& state, std::size_t request, std::size_t thread,
                                   Threads& result) const {
  add_users(state, Use::withdraw, request, thread, result);
  Threads owners = moves_.owners(state, pan::ChannelId(request));
  for (std::size_t owner = 0; owner < automata_.threads.size(); ++owner) {
    if (owner != thread && owners.test(owner)) result |= cancellers_[owner];
  }
}

/// `withdrawers`: also those that may withdraw the request that the thread waits for.
void Independence::add_channels(const State& state, std::size_t thread, bool withdrawers,
                                Threads& result) const {
  const auto& step = moves_.at(state, thread);
  const auto add = [&](Use use, std::size_t index) { add_users(state, use, index, thread, result); };
  for (const auto channel : step.channels) {
    const auto c = channel.index();
    const auto& request = automata_.request_of[c];
    const bool full = moves_.full(state, channel);
    if (step.kind == Step::Kind::send && automata_.to_device[c]) {
      add(Use::device, c);
      add_withdrawers(state, c, thread, result);
    } else if (step.kind == Step::Kind::send) {
      add(Use::put, c);
      add_withdrawers(state, c, thread, result);
      if (automata_.answer_of[c]) add(Use::take, automata_.answer_of[c]->index());
      // It answers a request that was taken, and none that is taken later.
      if (request) add(Use::take, request->index());
      // Putting an answer and then withdrawing it leaves what withdrawing the request first and then
      // discarding leaves.
      if (request && full) add_withdrawers(state, request->index(), thread, result);
      if (full) add(Use::take, c);
    } else if (automata_.from_device[c]) {
      if (!request) continue;
      add(Use::device, request->index());
      add_withdrawers(state, request->index(), thread, result);
    } else {
      add(Use::take, c);
      if (!full) add(Use::put, c);
      if (withdrawers) add_withdrawers(state, c, thread, result);
      if (full && observed_[c]) add(Use::complete, 0);
      if (automata_.answer_of[c]) add(Use::put, automata_.answer_of[c]->index());
      if (!request) continue;
      add(Use::put, request->index());
      add_withdrawers(state, request->index(), thread, result);
      if (step.gives_up) add(Use::take, request->index());
    }
  }
}

void Independence::add_conditions(const State& state, std::size_t thread, Threads& result) const {
  const auto& step = moves_.at(state, thread);
  std::vector<pan::ConditionId> conditions;
  if (step.kind == Step::Kind::set || step.kind == Step::Kind::latch) conditions.push_back(step.condition);
  for (const auto& guard : step.guards) conditions::conditions_of(guard, conditions);
  for (const auto condition : conditions) {
    const auto& bit = automata_.bit[condition.index()];
    if (!bit) continue;
    add_users(state, Use::write, *bit, thread, result);
    if (step.kind == Step::Kind::set) add_users(state, Use::read, *bit, thread, result);
  }
}

/// The one that alone can send what the thread waits for.
std::optional<std::size_t> Independence::helper(const State& state, std::size_t thread) const {
  if (!moves_.active(state, thread)) return std::nullopt;
  const auto& step = moves_.at(state, thread);
  if (step.kind != Step::Kind::wait || step.channels.size() != 1) return std::nullopt;
  const auto& users = users_[resource(Use::put, step.channels.front().index())];
  std::optional<std::size_t> found;
  for (std::size_t t = 0; t < automata_.threads.size(); ++t) {
    if (!users.test(t) || !moves_.active(state, t)) continue;
    if (found) return std::nullopt;
    found = t;
  }
  return found;
}

/// For a server that takes a request which may be withdrawn later. Then it may come back to where it is now,
/// with what it has of its own. If it does, taking first is as good. Returns the threads that may disturb it
/// on its way, or nothing if it is no such server.
std::optional<Threads> Independence::disturbing_service(const State& state, std::size_t thread,
                                                        const std::vector<Move>& moves) const {
  constexpr std::size_t most_moves = 64;
  if (moves.size() != 1 || moves.front().action.kind != Action::Kind::takes) return std::nullopt;
  if (moves_.finishing(state, thread)) return std::nullopt;
  const auto request = moves.front().action.channel;
  if (!automata_.answer_of[request.index()] || observed_[request.index()]) return std::nullopt;
  const auto back = moves_.without_request(state, request);
  auto at = moves_.without_request(moves.front().state, request);
  // Withdrawing changes one count, and of one that is not exact it cannot be told whether it comes back to
  // what it was.
  const auto answer = *automata_.answer_of[request.index()];
  if (moves_.blurred(back, answer) || moves_.blurred(at, answer)) return std::nullopt;
  Threads result;
  std::vector<std::size_t> at_work{thread};
  for (std::size_t i = 0; i < most_moves; ++i) {
    if (at == back) return result;
    const auto worker = at_work.back();
    std::vector<Move> next;
    moves_.of(at, worker, next);
    if (next.empty()) {
      const auto asked = helper(at, worker);
      if (!asked || std::find(at_work.begin(), at_work.end(), *asked) != at_work.end()) return std::nullopt;
      at_work.push_back(*asked);
      continue;
    }
    if (next.size() != 1 || next.front().timely || next.front().ended) return std::nullopt;
    for (std::size_t other = 0; other < automata_.threads.size(); ++other) {
      if (other != worker && at[other] != next.front().state[other]) return std::nullopt;
    }
    result |= disturbing_step(at, worker, true) | cancellers_[worker];
    at = std::move(next.front().state);
    // A thread that was helped goes on as soon as it can.
    if (at_work.size() > 1) {
      next.clear();
      moves_.of(at, at_work[at_work.size() - 2], next);
      if (!next.empty()) at_work.pop_back();
    }
  }
  return std::nullopt;
}

Threads Independence::disturbing_step(const State& state, std::size_t thread, bool withdrawers) const {
  Threads result;
  add_channels(state, thread, withdrawers, result);
  add_conditions(state, thread, result);
  return result;
}

Threads Independence::disturbing(const State& state, std::size_t thread,
                                 const std::vector<Move>& moves) const {
  const auto& step = moves_.at(state, thread);
  Threads result;
  if (step.kind == Step::Kind::join) {
    // It goes on when its blocks have ended: one of them must move first.
    for (const auto block : automata_.threads[thread].children) {
      if (!moves_.active(state, block)) continue;
      if (step.next.empty() || automata_.threads[block].can_end || moves_.finishing(state, block))
        result.set(block);
    }
    return result;
  }
  const auto service = absorb_ ? disturbing_service(state, thread, moves) : std::nullopt;
  result = disturbing_step(state, thread, !service);
  if (service) result |= *service;
  if (!moves.empty() && !(absorb_ && undone_by_cancelling(state, thread, moves)))
    result |= cancellers_[thread];
  result.reset(thread);
  return result;
}

std::optional<Threads> Independence::closure(const State& state, const Enabled& enabled,
                                             const Threads& seeds) const {
  Threads in;
  std::vector<std::size_t> open;
  const auto enter = [&](const Threads& threads) {
    for (std::size_t t = 0; t < automata_.threads.size(); ++t) {
      if (!threads.test(t) || in.test(t) || !moves_.active(state, t)) continue;
      in.set(t);
      open.push_back(t);
    }
  };
  enter(seeds);
  while (!open.empty()) {
    const auto thread = open.back();
    open.pop_back();
    if (concerns_all(state, thread, enabled[thread])) return std::nullopt;
    enter(disturbing(state, thread, enabled[thread]));
  }
  return in;
}

}  // namespace pal::check::deadlock
