// Threads, statement by statement.
#include "analyzer/run_checker/referee.hpp"

#include <algorithm>

namespace pal::analyzer::run_checker {

namespace {

bool holds(const pan::Guard& guard, const std::map<ConditionId, bool>& values) {
  switch (guard.kind) {
    case pan::Guard::Kind::equals:
      return values.at(guard.condition) == guard.value;
    case pan::Guard::Kind::negation:
      return !holds(guard.terms.front(), values);
    case pan::Guard::Kind::all_of:
      return std::all_of(guard.terms.begin(), guard.terms.end(),
                         [&](const pan::Guard& term) { return holds(term, values); });
    case pan::Guard::Kind::any_of:
      return std::any_of(guard.terms.begin(), guard.terms.end(),
                         [&](const pan::Guard& term) { return holds(term, values); });
  }
  return false;
}

void collect(const pan::Guard& guard, std::set<ConditionId>& conditions) {
  if (guard.kind == pan::Guard::Kind::equals) conditions.insert(guard.condition);
  for (const pan::Guard& term : guard.terms) collect(term, conditions);
}

}  // namespace

/// The thread comes to a statement: one with what led to it.
void Referee::reach(ThreadId thread, StepId step) {
  Party& of = party(thread);
  of.step = step;
  of.reached = now_;
  of.reached_by = at_;
  of.with = with_;
  of.place = ++reached_;
  of.work = 0;
  of.gives_up = of.withdrawn = of.acted = of.told = false;
  of.claim = ChannelId{};
  of.reads.clear();
  monitor_.reaches(thread, step);
  const Step& at = step_of(thread);
  if (at.kind == Step::Kind::end) {
    release(thread);
    of = {};
    monitor_.ends(thread);
    if (thread_of(thread).parent.valid()) {
      hands_over(thread, thread_of(thread).parent);
      block_over(thread_of(thread).parent);
    }
  } else if (at.kind == Step::Kind::fork) {
    release(thread);
    begin_blocks(thread);
  } else if (at.kind == Step::Kind::wait) {
    of.mode = Mode::arrived;
    arrive(thread);
    for (ChannelId channel : at.channels) {
      if (channel_of(channel).sender_device.valid()) open_device(channel_of(channel).sender_device);
    }
  } else {
    of.mode = Mode::ready;
    if (holder(thread) != thread) enqueue(thread, false, !beginning_ && !withdrawing_, with_);
  }
}

void Referee::begin_blocks(ThreadId thread) {
  party(thread).mode = Mode::joining;
  const std::vector<ThreadId> blocks = step_of(thread).threads;
  for (ThreadId block : blocks) {
    party(block) = {};
    party(block).mode = Mode::arrived;
    monitor_.begins(block, thread);
  }
  const StepId fork = party(thread).step;
  for (ThreadId block : blocks) {
    // One that is cancelled before it begins has come to nothing.
    if (party(block).mode != Mode::off && !party(block).must_stop) reach(block, thread_of(block).entry);
  }
  // Blocks with nothing in them are over before the run says that a thread waits for them.
  const bool waits = party(thread).mode == Mode::joining && party(thread).step == fork;
  if (!waits) passed_.emplace_back(thread, problem_.steps[fork].statement);
}

/// Whether a sender whose slot has become free has not come to its queue yet.
bool Referee::admits() const {
  for (const ThreadId t : threads_.ids()) {
    const Party& of = threads_[t];
    if (of.mode != Mode::sending) continue;
    if (of.acted || !slot(step_of(t).channels.front()).full) return true;
  }
  return false;
}

/// A block has ended or stopped: when all that can end have, the others are cancelled.
void Referee::block_over(ThreadId parent) {
  Party& of = party(parent);
  if (of.mode != Mode::joining) return;
  const std::vector<ThreadId> blocks = step_of(parent).threads;
  bool can_end = false;
  bool still = false;
  for (ThreadId block : blocks) {
    can_end = can_end || thread_of(block).can_end;
    still = still || (thread_of(block).can_end && party(block).mode != Mode::off);
  }
  if (of.must_stop || (can_end && !still)) {
    for (ThreadId block : blocks) {
      Party& other = party(block);
      if (other.mode == Mode::off || other.must_stop) continue;
      other.must_stop = true;
      if (other.mode == Mode::joining) block_over(block);
    }
  }
  for (ThreadId block : blocks) {
    if (party(block).mode != Mode::off) return;
  }
  if (of.mode != Mode::joining) return;
  if (of.must_stop) {
    of.mode = Mode::finished;
  } else {
    const bool before = withdrawing_;
    withdrawing_ = before || admits();
    reach(parent, step_of(parent).next.front());
    withdrawing_ = before;
  }
}

StepId Referee::next_of_test(ThreadId thread) const {
  const Step& step = step_of(thread);
  const Party& of = party(thread);
  std::set<ConditionId> mentioned;
  for (const pan::Guard& guard : step.guards) collect(guard, mentioned);
  std::map<ConditionId, bool> values = of.latched;
  for (const auto& [condition, value] : of.reads) {
    demand(mentioned.contains(condition) && !of.latched.contains(condition), name(thread),
           " reads what its test does not need");
    values[condition] = value;
  }
  for (const ConditionId condition : mentioned)
    demand(values.contains(condition), name(thread), " tests without reading");
  for (std::size_t i = 0; i < step.guards.size(); ++i) {
    if (holds(step.guards[i], values)) return step.next[i];
  }
  return step.next.size() > step.guards.size() ? step.next.back() : StepId{};
}

void Referee::done(const Event& event) {
  const ThreadId thread = ThreadId::of(event.actor);
  if (thread == midway_) midway_ = ThreadId{};
  Party& of = party(thread);
  const Step& step = step_of(thread);
  demand(of.mode == Mode::sending || of.mode == Mode::running, name(thread),
         " has an effect without running");
  if (of.mode == Mode::running) check_work(thread);
  StepId next{};
  bool completes = false;
  switch (step.kind) {
    case Step::Kind::wait:
      if (of.gives_up) {
        for (ChannelId channel : step.channels) {
          if (channel_of(channel).answers.valid()) gives_up(channel_of(channel).answers);
        }
        next = step.next.back();
      } else {
        demand(of.acted, name(thread), " receives without taking");
        const auto found = std::find(step.channels.begin(), step.channels.end(), of.claim);
        next = step.next[static_cast<std::size_t>(found - step.channels.begin())];
      }
      break;
    case Step::Kind::send:
      demand(of.acted, name(thread), " has sent nothing");
      next = step.next.front();
      break;
    case Step::Kind::set:
    case Step::Kind::read:
      demand(of.acted, name(thread), " has neither set nor read");
      next = step.next.front();
      break;
    case Step::Kind::test:
      next = next_of_test(thread);
      completes = !next.valid();
      of.latched.clear();
      break;
    case Step::Kind::activity:
      next = step.next.front();
      break;
    case Step::Kind::complete:
      completes = true;
      break;
    case Step::Kind::fork:
    case Step::Kind::end:
      broken("an effect where there is none");
  }
  if (step.kind == Step::Kind::activity) monitor_.uses(thread, of.step);
  monitor_.passes(thread, of.step);
  monitor_.writes(thread, of.step);
  if (completes || completed_) {
    demand(completes && completed_, "the skill completes where it does not, or does not where it does");
    const int code = step.kind == Step::Kind::complete ? step.code : problem_.error_code;
    const Event& before = events_[at_ - 1];
    demand(before.kind == Kind::complete && ThreadId::of(before.actor) == thread && before.value == code,
           "the skill completes with another code");
    monitor_.completes(thread, of.step, code);
    monitor_.skill_ends();
    ended_ = true;
    return;
  }
  if (of.must_stop) {
    of.mode = Mode::finished;
  } else {
    if (of.mode == Mode::sending) of.mode = Mode::ready;
    reach(thread, next);
  }
}

void Referee::blocked(const Event& event) {
  const ThreadId thread = ThreadId::of(event.actor);
  again(thread);
  Party& of = party(thread);
  const Step& step = step_of(thread);
  if (step.kind == Step::Kind::fork) {
    demand(of.mode == Mode::joining && event.subject < 0, name(thread), " waits for no blocks");
    demand(!of.told && of.reached == now_, name(thread), " waits for its blocks already");
    of.told = true;
    return;
  }
  const bool named = step.kind == Step::Kind::send || step.kind == Step::Kind::wait
                         ? std::find(step.channels.begin(), step.channels.end(),
                                     ChannelId::of(event.subject)) != step.channels.end()
                         : event.subject < 0;
  demand(named, name(thread), " waits for what it does not wait for here");
  if (step.kind == Step::Kind::send) {
    check_work(thread);
    demand(slot(step.channels.front()).full && !of.acted && !of.must_stop, name(thread),
           " blocks although its slot is free");
    release(thread);
    of.mode = Mode::sending;
    return;
  }
  demand(of.mode == Mode::arrived, name(thread), " blocks where it does not wait");
  demand(!step.within || *step.within > 0, name(thread), " waits although it has no time to");
  for (ChannelId channel : step.channels) not_there_yet(channel, thread);
  release(thread);
  of.mode = Mode::waiting;
}

void Referee::gave_up(const Event& event) {
  const auto thread = ThreadId::of(event.actor);
  again(thread);
  Party& of = party(thread);
  const Step& step = step_of(thread);
  demand(step.kind == Step::Kind::wait && step.within.has_value(), name(thread),
         " gives up what has no limit");
  demand(of.mode == (*step.within == 0 ? Mode::arrived : Mode::waiting), name(thread),
         " gives up without waiting");
  demand(now_ == of.reached + *step.within, name(thread), " gives up at another time than its limit");
  for (ChannelId channel : step.channels) not_there_yet(channel, thread);
  of.gives_up = true;
  resolve(thread);
}

void Referee::condition(const Event& event) {
  const auto thread = ThreadId::of(event.actor);
  Party& of = party(thread);
  const Step& step = step_of(thread);
  check_work(thread);
  const auto condition = ConditionId::of(event.subject);
  const bool value = event.value != 0;
  midway_ = thread;
  if (event.kind == Kind::set) {
    demand(step.kind == Step::Kind::set && step.condition == condition && !of.acted, name(thread),
           " sets what it does not set here");
    demand(!step.value || *step.value == value, name(thread), " sets another value");
    conditions_[condition] = value;
    of.acted = true;
    monitor_.uses(thread, of.step);
    monitor_.sets(thread, condition);
    return;
  }
  demand(conditions_[condition] == value, name(thread), " reads another value than was set");
  if (step.kind == Step::Kind::read) {
    demand(step.condition == condition && !of.acted, name(thread), " reads what it does not read here");
    of.latched[condition] = value;
    of.acted = true;
  } else {
    demand(step.kind == Step::Kind::test, name(thread), " reads what it does not read here");
    demand(!of.reads.contains(condition), name(thread), " reads a condition twice");
    of.reads[condition] = value;
  }
  monitor_.reads(thread, condition);
}

void Referee::cancelled(const Event& event) {
  const ThreadId thread = ThreadId::of(event.actor);
  Party& of = party(thread);
  demand(of.must_stop, name(thread), " is cancelled, and need not be");
  if (of.mode == Mode::running) {
    check_work(thread);
    const Step& step = step_of(thread);
    const bool given_up = step.kind == Step::Kind::send && slot(step.channels.front()).full && !of.acted;
    demand(given_up || of.withdrawn, name(thread), " is cancelled in a statement that it has begun");
  } else {
    const bool stops = of.mode == Mode::finished || of.mode == Mode::ready || of.mode == Mode::arrived ||
                       of.mode == Mode::waiting || of.mode == Mode::sending;
    demand(stops, name(thread), " is cancelled in a statement that it has begun");
  }
  release(thread);
  abandon(thread);
  of = {};
  monitor_.ends(thread);
  const bool withdraws =
      std::any_of(slots_.begin(), slots_.end(), [](const Slot& each) { return each.to_be_dropped; });
  withdrawing_ = withdraws || dropped_at_ == now_;
  if (thread_of(thread).parent.valid()) block_over(thread_of(thread).parent);
  withdrawing_ = false;
}

}  // namespace pal::analyzer::run_checker
