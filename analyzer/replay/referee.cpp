// Threads and processors.
#include "analyzer/replay/referee.hpp"

#include <algorithm>

namespace pal::analyzer::rules {
namespace {

bool holds(const pan::Guard& guard, const std::map<int, bool>& values) {
  switch (guard.kind) {
    case pan::Guard::Kind::equals:
      return values.at(guard.condition.value) == guard.value;
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

void collect(const pan::Guard& guard, std::set<int>& conditions) {
  if (guard.kind == pan::Guard::Kind::equals) conditions.insert(guard.condition.value);
  for (const pan::Guard& term : guard.terms) collect(term, conditions);
}

}  // namespace

Referee::Referee(const Problem& problem, const Requirement* requirement, const std::vector<Event>& events)
    : problem_(problem),
      requirement_(requirement),
      events_(events),
      threads_(problem.threads.size()),
      slots_(problem.channels.size()),
      devices_(problem.devices.size()),
      holders_(problem.processors.size(), -1),
      preempted_(problem.processors.size(), -1),
      conditions_(problem.conditions.size()) {}

void Referee::follow() {
  for (std::size_t d = 0; d < devices_.size(); ++d) {
    const auto* frames = std::get_if<pan::FrameDevice>(&problem_.devices[d].behaviour);
    if (frames == nullptr) continue;
    devices_[d].open = true;
    devices_[d].first_hi = frames->period.count();
    if (frames->phase) devices_[d].first_lo = devices_[d].first_hi = frames->phase->count();
  }
  for (std::size_t t = 0; t < threads_.size(); ++t) {
    if (problem_.threads[t].parent < 0) reach(static_cast<int>(t), problem_.threads[t].entry);
  }
  beginning_ = false;
  for (at_ = 0; at_ < events_.size(); ++at_) {
    const Event& event = events_[at_];
    demand(event.time_ns >= now_, "time runs backwards");
    if (event.time_ns > now_) {
      leave_instant(event.time_ns);
      passed_.clear();
    }
    now_ = event.time_ns;
    demand(!ended_, "something happens after the skill has ended");
    handle(event);
  }
  demand(!completed_ || ended_, "the skill's completion has no effect");
  if (!ended_) leave_instant(now_);
}

void Referee::handle(const Event& event) {
  const int threads = static_cast<int>(threads_.size());
  if (event.actor >= threads) {
    device_event(event, event.actor - threads);
    return;
  }
  if (event.actor < 0) {
    demand(event.kind == Kind::drop, "an event that nobody causes");
    drop(event);
    return;
  }
  const auto passed = std::find(passed_.begin(), passed_.end(), std::pair(event.actor, event.statement));
  if (event.kind == Kind::block && event.subject < 0 && passed != passed_.end()) {
    passed_.erase(passed);
    return;
  }
  const Party& of = party(event.actor);
  demand(of.mode != Mode::off, name(event.actor) + " acts without being there");
  demand(event.statement == (of.step < 0 ? -1 : step_of(event.actor).statement),
         name(event.actor) + " is at another statement than the event");
  demand(!completed_ || event.kind == Kind::done, "something happens after the skill has ended");
  switch (event.kind) {
    case Kind::ready:
      return was_ready(event);
    case Kind::start:
      return started(event);
    case Kind::stop:
      return stopped(event);
    case Kind::done:
      return done(event);
    case Kind::block:
      return blocked(event);
    case Kind::give_up:
      return gave_up(event);
    case Kind::put:
      return put(event);
    case Kind::take:
      return take(event);
    case Kind::drop:
      return drop(event);
    case Kind::set:
    case Kind::read:
      return condition(event);
    case Kind::cancel:
      return cancelled(event);
    case Kind::complete:
      completed_ = true;
      demand(of.mode == Mode::running, "the skill completes without an action");
      return;
    case Kind::overrun:
    case Kind::busy:
    case Kind::idle:
    case Kind::fault:
      break;
  }
  broken(std::string("a thread has no event ") + trace::name(event.kind));
}

Range Referee::cost(int thread) const {
  return party(thread).gives_up ? step_of(thread).give_up_cost : step_of(thread).cost;
}

/// The thread comes to a statement: one with what led to it.
void Referee::reach(int thread, int step) {
  Party& of = party(thread);
  of.step = step;
  of.reached = now_;
  of.work = 0;
  of.gives_up = of.withdrawn = of.acted = false;
  of.claim = -1;
  of.reads.clear();
  const Step& at = step_of(thread);
  if (at.kind == Step::Kind::end) {
    release(thread);
    of = {};
    if (thread_of(thread).parent >= 0) block_over(thread_of(thread).parent);
  } else if (at.kind == Step::Kind::fork) {
    release(thread);
    begin_blocks(thread);
  } else if (at.kind == Step::Kind::wait) {
    of.mode = Mode::arrived;
    for (int channel : at.channels) {
      if (channel_of(channel).sender_device >= 0) open_device(channel_of(channel).sender_device);
    }
  } else {
    of.mode = Mode::ready;
    if (holder(thread) != thread) enqueue(thread, false, !beginning_);
  }
}

void Referee::begin_blocks(int thread) {
  party(thread).mode = Mode::joining;
  const std::vector<int> blocks = step_of(thread).threads;
  for (int block : blocks) {
    party(block) = {};
    party(block).mode = Mode::arrived;
    party(block).read_born = party(thread).read_born;
    party(block).event = party(thread).event;
  }
  const int statement = step_of(thread).statement;
  for (int block : blocks) {
    // One that is cancelled before it begins has come to nothing.
    if (party(block).mode != Mode::off && !party(block).must_stop) reach(block, thread_of(block).entry);
  }
  // Blocks with nothing in them are over before the run says that somebody waits for them.
  if (party(thread).mode != Mode::joining) passed_.emplace_back(thread, statement);
}

/// A block has ended or stopped: when all that can end have, the others are cancelled.
void Referee::block_over(int parent) {
  Party& of = party(parent);
  if (of.mode != Mode::joining) return;
  const std::vector<int> blocks = step_of(parent).threads;
  bool can_end = false;
  bool still = false;
  for (int block : blocks) {
    can_end = can_end || thread_of(block).can_end;
    still = still || (thread_of(block).can_end && party(block).mode != Mode::off);
  }
  if (of.must_stop || (can_end && !still)) {
    for (int block : blocks) {
      Party& other = party(block);
      if (other.mode == Mode::off || other.must_stop) continue;
      other.must_stop = true;
      if (other.mode == Mode::joining) block_over(block);
    }
  }
  for (int block : blocks) {
    if (party(block).mode != Mode::off) return;
  }
  if (of.mode != Mode::joining) return;
  if (of.must_stop) {
    of.mode = Mode::finished;
  } else {
    reach(parent, step_of(parent).next.front());
  }
}

void Referee::release(int thread) {
  if (holder(thread) == thread) holder(thread) = -1;
  std::erase_if(queue_, [thread](const Queued& queued) { return queued.thread == thread; });
}

void Referee::enqueue(int thread, bool front, bool ordered) {
  const Queued made{thread, now_, ordered, front};
  queue_.insert(front ? queue_.begin() : queue_.end(), made);
}

/// A thread that was waiting, or has come to a wait, does not wait any more: a message has come.
void Referee::resolve(int thread) {
  Party& of = party(thread);
  if (of.mode != Mode::arrived && of.mode != Mode::waiting) return;
  const Step& at = step_of(thread);
  const bool waited = of.mode == Mode::waiting;
  if (!of.gives_up) {
    std::vector<int> candidates;
    for (int channel : at.channels) {
      const Slot& from = slot(channel);
      if (!from.full || from.claimed) continue;
      const Arrival& there = arrival(channel, thread);
      if (there.lo <= now_ && (!waited || now_ <= there.hi)) candidates.push_back(channel);
    }
    demand(!candidates.empty(), name(thread) + " goes on without a message");
    const int channel = message_of(thread, candidates);
    for (int earlier : at.channels) {
      if (earlier == channel) break;
      if (!waited) not_there_yet(earlier, thread);
    }
    Arrival& there = arrival(channel, thread);
    if (waited) there.lo = now_;
    there.hi = std::min(there.hi, now_);
    slot(channel).claimed = true;
    of.claim = channel;
  }
  of.mode = Mode::ready;
  if (holder(thread) != thread) enqueue(thread, false, false);
}

/// Whose message was withdrawn comes to its wait again at the effect.
void Referee::again(int thread) {
  Party& of = party(thread);
  if (of.mode != Mode::running || !of.withdrawn) return;
  check_work(thread);
  demand(!of.must_stop, name(thread) + " goes on although it is cancelled");
  reach(thread, of.step);
}

void Referee::was_ready(const Event& event) {
  again(event.actor);
  resolve(event.actor);
  demand(party(event.actor).mode == Mode::ready, name(event.actor) + " is not ready");
  demand(holder(event.actor) != event.actor, name(event.actor) + " has its processor");
}

void Referee::check_turn(int thread) const {
  const Thread& of = thread_of(thread);
  const auto own =
      std::find_if(queue_.begin(), queue_.end(), [&](const Queued& q) { return q.thread == thread; });
  bool before = true;
  for (auto other = queue_.begin(); other != queue_.end(); ++other) {
    if (other == own) {
      before = false;
      continue;
    }
    const Thread& rival = thread_of(other->thread);
    if (rival.processor != of.processor) continue;
    demand(rival.priority <= of.priority,
           of.name + " runs before " + rival.name + ", whose priority is greater");
    if (rival.priority < of.priority || !before || own == queue_.end()) continue;
    const bool either =
        !other->front && !own->front && other->at == own->at && !(other->ordered && own->ordered);
    demand(either, of.name + " runs before " + rival.name + ", which was first");
  }
}

void Referee::started(const Event& event) {
  const int thread = event.actor;
  again(thread);
  resolve(thread);
  Party& of = party(thread);
  demand(of.mode == Mode::ready || of.mode == Mode::stopped, name(thread) + " starts what it cannot start");
  int& loser = preempted_[static_cast<std::size_t>(thread_of(thread).processor)];
  demand(loser < 0 || thread_of(thread).priority > thread_of(loser).priority,
         "a thread is stopped for nothing");
  loser = -1;
  int& has = holder(thread);
  if (has != thread) {
    if (has >= 0) {
      const int before = has;
      resolve(before);
      const pan::Processor& processor =
          problem_.processors[static_cast<std::size_t>(thread_of(thread).processor)];
      demand(party(before).mode == Mode::ready, name(thread) + " starts while " + name(before) + " runs");
      demand(processor.preemptive && thread_of(thread).priority > thread_of(before).priority,
             name(thread) + " takes the processor that " + name(before) + " keeps");
      has = -1;
      enqueue(before, true, true);
    }
    check_turn(thread);
    release(thread);
    has = thread;
  } else {
    const bool preemptive =
        problem_.processors[static_cast<std::size_t>(thread_of(thread).processor)].preemptive;
    for (const Queued& queued : queue_) {
      const Thread& rival = thread_of(queued.thread);
      const bool first = preemptive && rival.processor == thread_of(thread).processor &&
                         rival.priority > thread_of(thread).priority;
      demand(!first, name(thread) + " runs before " + rival.name + ", whose priority is greater");
    }
  }
  of.mode = Mode::running;
  of.since = now_;
}

void Referee::stopped(const Event& event) {
  Party& of = party(event.actor);
  demand(of.mode == Mode::running, name(event.actor) + " is stopped without running");
  demand(problem_.processors[static_cast<std::size_t>(thread_of(event.actor).processor)].preemptive,
         name(event.actor) + " is preempted on a processor that does not");
  of.work += now_ - of.since;
  of.mode = Mode::stopped;
  preempted_[static_cast<std::size_t>(thread_of(event.actor).processor)] = event.actor;
  holder(event.actor) = -1;
  enqueue(event.actor, true, true);
}

void Referee::check_work(int thread) const {
  const Party& of = party(thread);
  demand(of.mode == Mode::running, name(thread) + " has an effect without running");
  const Nanoseconds work = of.work + now_ - of.since;
  demand(work >= cost(thread).best, name(thread) + " is done after too little processor time");
  demand(work <= cost(thread).worst, name(thread) + " is done after too much processor time");
}

int Referee::next_of_test(int thread) const {
  const Step& step = step_of(thread);
  const Party& of = party(thread);
  std::set<int> mentioned;
  for (const pan::Guard& guard : step.guards) collect(guard, mentioned);
  std::map<int, bool> values = of.latched;
  for (const auto& [condition, value] : of.reads) {
    demand(mentioned.contains(condition) && !of.latched.contains(condition),
           name(thread) + " reads what its test does not need");
    values[condition] = value;
  }
  for (int condition : mentioned) demand(values.contains(condition), name(thread) + " tests without reading");
  for (std::size_t i = 0; i < step.guards.size(); ++i) {
    if (holds(step.guards[i], values)) return step.next[i];
  }
  return step.next.size() > step.guards.size() ? step.next.back() : -1;
}

void Referee::done(const Event& event) {
  const int thread = event.actor;
  Party& of = party(thread);
  const Step& step = step_of(thread);
  demand(of.mode == Mode::sending || of.mode == Mode::running,
         name(thread) + " has an effect without running");
  if (of.mode == Mode::running) check_work(thread);
  int next = -1;
  bool completes = false;
  switch (step.kind) {
    case Step::Kind::wait:
      if (of.gives_up) {
        for (int channel : step.channels) {
          if (channel_of(channel).answers >= 0) withdraw_all(channel_of(channel).answers);
        }
        next = step.next.back();
      } else {
        demand(of.acted, name(thread) + " receives without taking");
        const auto found = std::find(step.channels.begin(), step.channels.end(), of.claim);
        next = step.next[static_cast<std::size_t>(found - step.channels.begin())];
      }
      break;
    case Step::Kind::send: {
      next = step.next.front();
      const Step::Kind after = problem_.steps[static_cast<std::size_t>(next)].kind;
      const bool either = after == Step::Kind::fork || after == Step::Kind::end;
      if (!of.acted && either && of.mode == Mode::running) {
        of.owes_put = step.channels.front();
      } else {
        demand(of.acted, name(thread) + " has sent nothing");
      }
      break;
    }
    case Step::Kind::set:
    case Step::Kind::read:
      demand(of.acted, name(thread) + " has neither set nor read");
      next = step.next.front();
      break;
    case Step::Kind::test:
      next = next_of_test(thread);
      completes = next < 0;
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
  measure(thread);
  if (completes || completed_) {
    demand(completes && completed_, "the skill completes where it does not, or does not where it does");
    const int code = step.kind == Step::Kind::complete ? step.code : problem_.error_code;
    demand(at_ > 0 && events_[at_ - 1].kind == Kind::complete && events_[at_ - 1].value == code,
           "the skill completes with another code");
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
  const int thread = event.actor;
  again(thread);
  Party& of = party(thread);
  const Step& step = step_of(thread);
  if (step.kind == Step::Kind::fork) {
    demand(of.mode == Mode::joining, name(thread) + " waits for no blocks");
    return;
  }
  if (step.kind == Step::Kind::send) {
    check_work(thread);
    demand(slot(step.channels.front()).full && !of.acted && !of.must_stop,
           name(thread) + " blocks although its slot is free");
    release(thread);
    of.mode = Mode::sending;
    return;
  }
  demand(of.mode == Mode::arrived, name(thread) + " blocks where it does not wait");
  demand(!step.within || *step.within > 0, name(thread) + " waits although it has no time to");
  for (int channel : step.channels) not_there_yet(channel, thread);
  release(thread);
  of.mode = Mode::waiting;
}

void Referee::gave_up(const Event& event) {
  again(event.actor);
  Party& of = party(event.actor);
  const Step& step = step_of(event.actor);
  demand(step.kind == Step::Kind::wait && step.within.has_value(),
         name(event.actor) + " gives up what has no limit");
  demand(of.mode == (*step.within == 0 ? Mode::arrived : Mode::waiting),
         name(event.actor) + " gives up without waiting");
  demand(now_ == of.reached + *step.within, name(event.actor) + " gives up at another time than its limit");
  for (int channel : step.channels) not_there_yet(channel, event.actor);
  of.gives_up = true;
  resolve(event.actor);
}

void Referee::condition(const Event& event) {
  Party& of = party(event.actor);
  const Step& step = step_of(event.actor);
  check_work(event.actor);
  const auto condition = static_cast<std::size_t>(event.subject);
  const bool value = event.value != 0;
  const bool watched = requirement_ != nullptr && requirement_->measure == Requirement::Measure::age &&
                       requirement_->condition == event.subject;
  if (event.kind == Kind::set) {
    demand(step.kind == Step::Kind::set && step.condition == event.subject && !of.acted,
           name(event.actor) + " sets what it does not set here");
    demand(!step.value || *step.value == value, name(event.actor) + " sets another value");
    conditions_[condition] = value;
    of.acted = true;
    if (watched) condition_born_ = now_;
    return;
  }
  demand(conditions_[condition] == value, name(event.actor) + " reads another value than was set");
  if (step.kind == Step::Kind::read) {
    demand(step.condition == event.subject && !of.acted,
           name(event.actor) + " reads what it does not read here");
    of.latched[event.subject] = value;
    of.acted = true;
  } else {
    demand(step.kind == Step::Kind::test, name(event.actor) + " reads what it does not read here");
    of.reads[event.subject] = value;
  }
  if (watched) of.read_born = condition_born_;
}

void Referee::cancelled(const Event& event) {
  const int thread = event.actor;
  Party& of = party(thread);
  demand(of.must_stop, name(thread) + " is cancelled, and need not be");
  if (of.mode == Mode::running) {
    check_work(thread);
    const Step& step = step_of(thread);
    const bool given_up = step.kind == Step::Kind::send && slot(step.channels.front()).full && !of.acted;
    demand(given_up || of.withdrawn, name(thread) + " is cancelled in a statement that it has begun");
  } else {
    const bool stops = of.mode == Mode::finished || of.mode == Mode::ready || of.mode == Mode::arrived ||
                       of.mode == Mode::waiting || of.mode == Mode::sending;
    demand(stops, name(thread) + " is cancelled in a statement that it has begun");
  }
  release(thread);
  abandon(thread);
  of = {};
  if (thread_of(thread).parent >= 0) block_over(thread_of(thread).parent);
}

void Referee::measure(int thread) {
  if (requirement_ == nullptr || requirement_->measure == Requirement::Measure::load) return;
  Party& of = party(thread);
  if (!requirement_->at[static_cast<std::size_t>(of.step)]) return;
  const int statement = step_of(thread).statement;
  if (requirement_->measure == Requirement::Measure::age) {
    if (of.read_born) measured_.push_back({now_ - *of.read_born, *of.read_born, now_, statement});
    return;
  }
  if (of.event < 0 || born_[static_cast<std::size_t>(of.event)].answered) return;
  Born& event = born_[static_cast<std::size_t>(of.event)];
  for (int earlier = 0; earlier < of.event; ++earlier) {
    if (!born_[static_cast<std::size_t>(earlier)].answered) failed_ = true;
  }
  event.answered = true;
  measured_.push_back({now_ - event.at, event.at, now_, statement});
}

/// What must be so before time goes on to `next`.
void Referee::leave_instant(Nanoseconds next) const {
  for (std::size_t t = 0; t < threads_.size(); ++t) check_thread(static_cast<int>(t), next);
  for (std::size_t p = 0; p < holders_.size(); ++p) check_processor(static_cast<int>(p));
  for (std::size_t d = 0; d < devices_.size(); ++d) check_device(static_cast<int>(d), next);
  for (const Slot& of : slots_) {
    demand(of.unexplained_drops == 0, "a message is withdrawn, and nobody gave up");
    demand(of.expected_drops == 0, "a message that was withdrawn is still there");
  }
}

void Referee::check_thread(int thread, Nanoseconds next) const {
  const Party& of = party(thread);
  demand(of.owes_put < 0, name(thread) + " has sent nothing");
  const bool idle = of.mode == Mode::ready || of.mode == Mode::waiting || of.mode == Mode::sending;
  demand(of.mode != Mode::arrived, name(thread) + " neither waits nor goes on");
  demand(of.mode != Mode::finished && !(of.must_stop && idle), name(thread) + " is cancelled and goes on");
  if (of.mode == Mode::running) {
    demand(!of.acted && of.reads.empty(), name(thread) + " does half of a statement");
    demand(of.work + next - of.since <= cost(thread).worst, name(thread) + " works for too long");
  }
  if (of.mode == Mode::sending) {
    demand(slot(step_of(thread).channels.front()).full, name(thread) + " waits for a slot that is free");
  }
  if (of.mode != Mode::waiting) return;
  const Step& step = step_of(thread);
  demand(!step.within || next <= of.reached + *step.within, name(thread) + " waits beyond its limit");
  for (int channel : step.channels) {
    const Slot& from = slot(channel);
    if (!from.full || from.claimed) continue;
    demand(!surely_there(channel, thread) && arrival(channel, thread).hi >= next,
           name(thread) + " waits for a message that is there");
  }
}

void Referee::check_processor(int processor) const {
  const int has = holders_[static_cast<std::size_t>(processor)];
  demand(preempted_[static_cast<std::size_t>(processor)] < 0, "a thread is stopped for nothing");
  if (has >= 0) demand(party(has).mode == Mode::running, name(has) + " keeps its processor idle");
  for (const Queued& queued : queue_) {
    const Thread& of = thread_of(queued.thread);
    if (of.processor != processor) continue;
    demand(has >= 0, of.name + " is ready, and its processor idle");
    const bool yields = problem_.processors[static_cast<std::size_t>(processor)].preemptive;
    demand(!yields || of.priority <= thread_of(has).priority, of.name + " has to wait for a lesser priority");
  }
}

}  // namespace pal::analyzer::rules
