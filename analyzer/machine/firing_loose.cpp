// Messages whose other end is left out of a slice: they come at any time, and find their slot full or free
// (docs/internals/slices.md).
#include <algorithm>

#include "analyzer/machine/firing.hpp"

namespace pal::analyzer {
namespace {

/// Of the ways on from where a block that is left out stays: the one to its end, if it has one. The other is
/// what it finishes when it is cancelled.
constexpr int left_out_ends = 1;

}  // namespace

bool Firing::is_loose(const Problem& problem, const Step& step) {
  if (step.kind == Step::Kind::wait && step.channels.empty()) return true;
  return std::any_of(step.channels.begin(), step.channels.end(),
                     [&problem](ChannelId channel) { return problem.channels[channel].loose; });
}

/// Whether the thread is stopped at a wait or a send that a party that is left out may end.
bool Firing::is_loose(ThreadId thread) const {
  const Status status = state_of(thread).status;
  return (status == Status::waiting || status == Status::sending) && is_loose(problem_, step_of(thread));
}

bool Firing::ends_loosely(const Step& step, std::size_t branch) const {
  return step.channels.empty() || channel_of(step.channels[branch]).loose;
}

/// One of the ways on from a wait that no kept thread decides; or ThreadState::gives_up.
int Firing::loose_branch(const Step& step, bool gives_up) {
  std::vector<int> ways;
  if (step.channels.empty()) return left_out_ends;
  for (std::size_t i = 0; i < step.channels.size(); ++i) {
    if (channel_of(step.channels[i]).loose) ways.push_back(static_cast<int>(i));
  }
  if (gives_up) ways.push_back(ThreadState::gives_up);
  return ways[ways.size() == 1 ? 0 : static_cast<std::size_t>(choices_.pick(static_cast<int>(ways.size())))];
}

/// A block that is left out, and is cancelled, stops at once, or finishes first what it has begun. Whether it
/// does: then it is at work from now on.
bool Firing::finishes_first(ThreadId thread) {
  if (!thread_of(thread).left_out || !state_of(thread).at().valid() || choices_.pick(2) == 0) return false;
  stop_waiting(thread);
  state_of(thread).choice = ThreadState::no_choice;
  state_of(thread).go_to(step_of(thread).next.front());
  need_processor(thread);
  return true;
}

/// The thread is stopped at a wait that a party that is left out may end. If a message comes only so late it
/// may not come at all; then nothing is left to end the wait, unless another party does.
void Firing::wait_loosely(ThreadId thread) {
  const Step& step = step_of(thread);
  const Nanoseconds longest = step.within.value_or(step.arrival.worst);
  if (step.channels.empty() && static_cast<int>(step.next.size()) <= left_out_ends) {
    state_of(thread).choice = ThreadState::for_ever;
    return;
  }
  const bool limited = step.arrival.worst < Range::unbounded && !step.within;
  if (limited && choices_.pick(2) == 1) {
    state_of(thread).choice = ThreadState::for_ever;
    return;
  }
  start_timer(machine_.thread_timer(thread), {std::min(step.arrival.best, longest), longest});
}

/// Another party ends the wait, or the send: its timer is stopped, if it has one.
void Firing::stop_waiting(ThreadId thread) {
  const bool timed =
      is_loose(thread) || (state_of(thread).status == Status::waiting && step_of(thread).within);
  if (timed && state_of(thread).choice != ThreadState::for_ever) stop_timer(machine_.thread_timer(thread));
}

/// The timer of a thread that waits, or whose send is blocked: it goes on.
void Firing::loosened(ThreadId thread) {
  if (state_of(thread).status == Status::sending) {
    state_of(thread).status = Status::ready;
    return sent(thread, false);
  }
  const int branch = loose_branch(step_of(thread), step_of(thread).within.has_value());
  if (branch == ThreadState::gives_up) emit(Kind::give_up, thread, step_of(thread).channels.front());
  state_of(thread).choice = static_cast<std::int8_t>(branch);
  need_processor(thread);
}

/// Whether what the thread receives may be withdrawn meanwhile.
bool Firing::may_be_withdrawn(const Step& step, std::size_t branch) const {
  if (step.channels.empty()) return false;
  const Channel& of = channel_of(step.channels[branch]);
  return of.withdrawable && !(step.before_blocks && of.answers.valid());
}

void Firing::effect_loose_wait(ThreadId thread, std::size_t branch) {
  const Step& step = step_of(thread);
  if (may_be_withdrawn(step, branch) && choices_.pick(2) == 1) {
    if (state_of(thread).cancelled) return stop(thread);
    return reach(thread, state_of(thread).at());
  }
  state_of(thread).choice = ThreadState::no_choice;
  // No thread has a sample of a sender that is left out.
  if (!step.channels.empty()) has_taken(thread, step.channels[branch], tag::none);
  measure(thread);
  go_on_and_admit(thread, step.next[branch], {});
}

/// The slot is free, or becomes free later. If it does so within a limit, it may as well never do so: then
/// nothing is left to end the send.
void Firing::effect_loose_send(ThreadId thread) {
  constexpr int free = 0;
  constexpr int never_free = 2;
  const Nanoseconds longest = step_of(thread).arrival.worst;
  const int found = choices_.pick(longest < Range::unbounded ? 3 : 2);
  if (found == free) return sent(thread, false);
  if (state_of(thread).cancelled) return stop(thread);
  leave_processor(thread);
  state_of(thread).status = Status::sending;
  emit(Kind::block, thread, step_of(thread).channels.front());
  if (found == never_free) {
    state_of(thread).choice = ThreadState::for_ever;
  } else {
    start_timer(machine_.thread_timer(thread), {0, longest});
  }
}

/// Whether no thread can set it before its processor turns to another thread, or pauses.
bool Firing::cannot_change(ConditionId condition) const {
  if (problem_.setters.empty()) return false;
  const Setters& setters = problem_.setters[condition];
  if (!setters.processor.valid()) return false;
  const ThreadNumber runs = state_.running[setters.processor];
  return runs >= 0 && !setters.threads[ThreadId::of(runs)];
}

/// The next reads of a free condition give the same value, as long as it cannot change.
void Firing::hold(ConditionId condition, bool value) {
  if (!cannot_change(condition)) return;
  const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(condition.index());
  state_.held |= bit;
  state_.conditions = value ? state_.conditions | bit : state_.conditions & ~bit;
}

/// Forgets the values of free conditions that can change from now on.
void Firing::let_change() {
  if (state_.held == 0) return;
  for (const ConditionId condition : problem_.setters.ids()) {
    const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(condition.index());
    if ((state_.held & bit) == 0 || (cannot_change(condition) && !state_.ended)) continue;
    state_.held &= ~bit;
    state_.conditions &= ~bit;
  }
}

}  // namespace pal::analyzer
