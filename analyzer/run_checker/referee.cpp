// The run, event by event, and what must be so whenever time goes on.
#include "analyzer/run_checker/referee.hpp"

#include <algorithm>

namespace pal::analyzer::run_checker {

constexpr std::size_t events_between_stops = 1'000;

Referee::Referee(const Problem& problem, const Requirement* requirement, const trace::Events& events,
                 BusyFrom busy_from)
    : problem_(problem),
      events_(events),
      threads_(problem.threads.size()),
      slots_(problem.channels.size()),
      devices_(problem.devices.size()),
      holders_(problem.processors.size()),
      preempted_(problem.processors.size()),
      conditions_(problem.conditions.size()),
      monitor_(problem, requirement, busy_from) {
  events_of_.resize(problem.threads.size() + problem.devices.size());
  for (std::size_t e = 0; e < events.size(); ++e) {
    if (events[e].actor >= 0) events_of_[static_cast<std::size_t>(events[e].actor)].push_back(e);
  }
}

bool Referee::follow(std::optional<Nanoseconds> until, const std::function<bool()>& stop) {
  for (const DeviceId d : devices_.ids()) {
    const auto* frames = std::get_if<pan::FrameDevice>(&problem_.devices[d].behaviour);
    if (frames == nullptr) continue;
    devices_[d].open = true;
    devices_[d].first_hi = frames->period.count();
    if (frames->phase) devices_[d].first_lo = devices_[d].first_hi = frames->phase->count();
  }
  for (const ThreadId t : threads_.ids()) {
    if (problem_.threads[t].parent.valid()) continue;
    ++with_;
    reach(t, problem_.threads[t].entry);
  }
  beginning_ = false;
  for (at_ = 0; at_ < events_.size(); ++at_) {
    if (stop && at_ % events_between_stops == 0 && stop()) return false;
    const Event& event = events_[at_];
    demand(event.time_ns >= now_, "time runs backwards");
    demand(!ended_, "something happens after the skill has ended");
    if (event.time_ns > now_) {
      leave_instant(event.time_ns);
      passed_.clear();
    }
    now_ = event.time_ns;
    monitor_.at(now_);
    ++with_;
    handle(event);
  }
  if (!ended_) leave_instant(std::max(now_, until.value_or(now_)));
  return true;
}

void Referee::handle(const Event& event) {
  const auto actor = ThreadId::of(event.actor);
  const int threads = static_cast<int>(threads_.size());
  if (midway_.valid() && actor != midway_) check_between(event);
  if (is_effect(event)) {
    check_settled();
    ++effects_;
  }
  if (event.actor >= threads) {
    device_event(event, DeviceId::of(event.actor - threads));
    return;
  }
  if (event.actor < 0) {
    demand(event.kind == Kind::drop, "an event without a cause");
    drop(event);
    return;
  }
  const auto passed =
      std::find(passed_.begin(), passed_.end(), std::pair(actor, StatementId::of(event.statement)));
  if (event.kind == Kind::block && event.subject < 0 && passed != passed_.end()) {
    passed_.erase(passed);
    return;
  }
  const Party& of = party(actor);
  demand(of.mode != Mode::off, name(actor), " acts without being there");
  demand(StatementId::of(event.statement) == (!of.step.valid() ? StatementId{} : step_of(actor).statement),
         name(actor), " is at another statement than the event");
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
    case Kind::broken:
      break;
  }
  broken(std::string("a thread has no event ") + trace::name(event.kind));
}

/// Whether the event is, or begins, something that does not follow from something else at its instant.
bool Referee::is_effect(const Event& event) const {
  const auto thread = ThreadId::of(event.actor);
  const int threads = static_cast<int>(threads_.size());
  if (event.actor >= threads) {
    const Device& of = problem_.devices[DeviceId::of(event.actor - threads)];
    const bool occurs = event.kind == Kind::put || event.kind == Kind::overrun;
    return event.kind == Kind::idle || (occurs && std::holds_alternative<pan::EventDevice>(of.behaviour));
  }
  // The effect of a wait that gives up begins with what it withdraws.
  if (event.actor < 0 && event.subject >= 0 && slot(ChannelId::of(event.subject)).full)
    return !slot(ChannelId::of(event.subject)).to_be_dropped;
  if (event.actor < 0 || thread == midway_) return false;
  const Party& of = party(thread);
  if (of.mode != Mode::running || of.acted || !of.reads.empty()) return false;
  return event.kind == Kind::put || event.kind == Kind::take || event.kind == Kind::set ||
         event.kind == Kind::read || event.kind == Kind::done;
}

/// What must be so before the next effect at the same instant. All that follows from the effects before has
/// happened, and each thread that can run has begun.
void Referee::check_settled() const {
  for (const ThreadId t : threads_.ids()) {
    const Party& of = threads_[t];
    const ThreadId thread = t;
    demand(of.mode != Mode::arrived, name(thread), " neither waits nor goes on");
    check_stopped(thread);
    if (of.mode == Mode::sending)
      demand(slot(step_of(thread).channels.front()).full && !of.acted, name(thread),
             " waits for a slot that is free");
    if (of.mode != Mode::waiting) continue;
    for (ChannelId channel : step_of(thread).channels)
      demand(!surely_there(channel, thread), name(thread), " waits for a message that is there");
  }
  check_processors();
}

/// Between what a statement does and its end. When it has set or read a condition, nothing comes between.
/// When it has put or taken a message, a thread that it frees may go on, and its device may take what it
/// sends. But no other statement has its effect.
void Referee::check_between(const Event& event) const {
  const int threads = static_cast<int>(threads_.size());
  const Step::Kind kind = step_of(midway_).kind;
  const bool device = event.actor >= threads;
  const bool taken = kind == Step::Kind::send && (event.kind == Kind::busy || event.kind == Kind::take);
  const bool message = kind == Step::Kind::wait || kind == Step::Kind::send;
  const bool acts = event.kind == Kind::put || event.kind == Kind::take || event.kind == Kind::set ||
                    event.kind == Kind::read || event.kind == Kind::complete || event.kind == Kind::done;
  const bool effect =
      event.actor >= 0 && !device && acts && party(ThreadId::of(event.actor)).mode == Mode::running;
  demand(message && !effect && (!device || taken), name(midway_), " is interrupted in its effect");
}

/// What must be so before time goes on to `next`.
void Referee::leave_instant(Nanoseconds next) const {
  demand(!completed_, "the skill's completion has no effect");
  for (const ThreadId t : threads_.ids()) check_thread(t, next);
  check_processors();
  for (const DeviceId d : devices_.ids()) check_device(d, next);
  for (const ChannelId c : slots_.ids()) {
    const Slot& of = slots_[c];
    if (of.full && problem_.channels[c].receiver_device.valid()) check_asked(c);
    demand(!of.given_up, "a message is withdrawn, but no thread gave up");
    demand(!of.to_be_dropped, "a message that was withdrawn is still there");
  }
}

/// A cancelled thread has stopped, unless it finishes a statement, or waits for those that do.
void Referee::check_stopped(ThreadId thread) const {
  const Party& of = party(thread);
  const bool idle = of.mode == Mode::ready || of.mode == Mode::waiting || of.mode == Mode::sending;
  demand(of.mode != Mode::finished && !(of.must_stop && idle), name(thread), " is cancelled and goes on");
}

void Referee::check_thread(ThreadId thread, Nanoseconds next) const {
  const Party& of = party(thread);
  demand(of.mode != Mode::arrived, name(thread), " neither waits nor goes on");
  check_stopped(thread);
  demand(!of.acted && of.reads.empty(), name(thread), " does half of a statement");
  if (of.mode == Mode::running) {
    demand(of.work + next - of.since <= cost(thread).worst, name(thread), " works for too long");
  }
  if (of.mode == Mode::sending) {
    demand(slot(step_of(thread).channels.front()).full, name(thread), " waits for a slot that is free");
  }
  if (of.mode != Mode::waiting) return;
  const Step& step = step_of(thread);
  demand(!step.within || next <= of.reached + *step.within, name(thread), " waits beyond its limit");
  for (ChannelId channel : step.channels) {
    const Slot& from = slot(channel);
    if (!from.full || from.claimed) continue;
    demand(!surely_there(channel, thread) && arrival(channel, thread).hi >= next, name(thread),
           " waits for a message that is there");
  }
}

void Referee::check_processors() const {
  for (const ThreadId stopped : preempted_) demand(!stopped.valid(), "a thread is stopped for nothing");
  for (const ThreadId has : holders_) {
    if (has.valid()) demand(party(has).mode == Mode::running, name(has), " keeps its processor idle");
  }
  for (const Queued& queued : queue_) {
    const Thread& of = thread_of(queued.thread);
    const ThreadId has = holders_[of.processor];
    demand(has.valid(), of.name, " is ready, and its processor idle");
    const bool yields = problem_.processors[of.processor].preemptive;
    demand(!yields || of.priority <= thread_of(has).priority, of.name, " has to wait for a lesser priority");
  }
}

bool Referee::may_come(const Table<StepId, bool>& at) const {
  if (completed_) return false;
  std::vector<StepId> open;
  for (const ThreadId t : threads_.ids()) {
    const Party& of = threads_[t];
    if (of.mode == Mode::off || of.mode == Mode::finished) continue;
    const Step& step = step_of(t);
    if (of.must_stop) {
      if (at[of.step]) return true;
    } else if (of.mode == Mode::joining) {
      // Its blocks count for themselves.
      const bool goes_on = std::any_of(step.threads.begin(), step.threads.end(),
                                       [this](ThreadId block) { return thread_of(block).can_end; });
      if (goes_on) open.push_back(step.next.front());
    } else {
      open.push_back(of.step);
    }
  }
  Table<StepId, bool> seen(problem_.steps.size());
  while (!open.empty()) {
    const StepId here = open.back();
    open.pop_back();
    if (at[here]) return true;
    if (seen[here]) continue;
    seen[here] = true;
    const Step& step = problem_.steps[here];
    open.insert(open.end(), step.next.begin(), step.next.end());
    for (ThreadId block : step.threads) open.push_back(thread_of(block).entry);
  }
  return false;
}

}  // namespace pal::analyzer::run_checker
