// Messages: slots, latencies, and requests that are withdrawn.
#include <algorithm>

#include "analyzer/run_checker/referee.hpp"

namespace pal::analyzer::run_checker {

Referee::Arrival& Referee::arrival(ChannelId channel, ThreadId thread) {
  Slot& of = slot(channel);
  return of.arrival[of.from == thread_of(thread).processor ? 0 : 1];
}

const Referee::Arrival& Referee::arrival(ChannelId channel, ThreadId thread) const {
  const Slot& of = slot(channel);
  return of.arrival[of.from == thread_of(thread).processor ? 0 : 1];
}

bool Referee::surely_there(ChannelId channel, ThreadId thread) const {
  const Slot& of = slot(channel);
  if (!of.full || of.claimed) return false;
  return of.immediate[of.from == thread_of(thread).processor ? 0 : 1] || arrival(channel, thread).hi < now_;
}

/// Whether a thread that has come to a wait left the message that it found there to one that came together
/// with it, and later.
bool Referee::left_to_later(ChannelId channel, ThreadId thread) const {
  const Slot& of = slot(channel);
  const Party& earlier = party(thread);
  if (!of.claimed || earlier.mode != Mode::arrived || of.put_by >= earlier.reached_by) return false;
  const bool there =
      of.immediate[of.from == thread_of(thread).processor ? 0 : 1] || arrival(channel, thread).hi < now_;
  return there && std::any_of(threads_.begin(), threads_.end(), [&](const Party& later) {
           return later.mode != Mode::off && later.claim == channel && later.with == earlier.with &&
                  later.place > earlier.place;
         });
}

/// A thread goes on as if the channel had nothing for it: what is there must still be on its way.
void Referee::not_there_yet(ChannelId channel, ThreadId thread) {
  // Unless it is there for another thread, which goes on with it at this instant.
  for (const ThreadId other : threads_.ids()) {
    if (!surely_there(channel, thread)) break;
    const bool waits = threads_[other].mode == Mode::arrived || threads_[other].mode == Mode::waiting;
    if (!waits || other == thread || !goes_on(other)) continue;
    const std::vector<ChannelId>& channels = step_of(other).channels;
    if (std::find(channels.begin(), channels.end(), channel) != channels.end()) resolve(other);
  }
  demand(!surely_there(channel, thread) && !left_to_later(channel, thread), name(thread),
         " passes over a message that is there");
  const Slot& of = slot(channel);
  if (of.full && !of.claimed) arrival(channel, thread).lo = std::max(arrival(channel, thread).lo, now_);
}

/// Which of several messages the thread has chosen. It is the one that the thread takes in the end. Or it was
/// withdrawn, so the thread comes to its wait again; of several such messages it is the first. If the run
/// does not say, it is the first of all.
ChannelId Referee::message_of(ThreadId thread, const std::vector<ChannelId>& candidates) const {
  auto withdrawn = candidates.end();
  bool started = false;
  bool stopped = false;
  for (std::size_t e = at_; candidates.size() > 1 && e < events_.size(); ++e) {
    const Event& event = events_[e];
    const auto which = std::find(candidates.begin(), candidates.end(), ChannelId::of(event.subject));
    if (event.kind == Kind::drop && event.actor < 0) withdrawn = std::min(withdrawn, which);
    if (ThreadId::of(event.actor) != thread) continue;
    if (event.kind == Kind::take)
      return which != candidates.end() ? ChannelId::of(event.subject) : candidates.front();
    if (event.kind == Kind::cancel) break;
    const bool again = event.kind == Kind::block || (event.kind == Kind::start && started && !stopped);
    if (withdrawn != candidates.end() && again) return *withdrawn;
    started = started || event.kind == Kind::start;
    stopped = event.kind == Kind::stop;
  }
  return candidates.front();
}

void Referee::fill(ChannelId channel, ProcessorId processor) {
  Slot& to = slot(channel);
  to.answers = answered_next(channel).has_value();
  to.full = true;
  to.claimed = to.there_again = false;
  to.from = processor;
  to.put = now_;
  to.put_by = at_;
  const Range none{0, 0};
  const bool flies = processor.valid();
  const Range latency[2] = {flies ? problem_.within_processor : none,
                            flies ? problem_.between_processors : none};
  for (int way = 0; way < 2; ++way) {
    to.immediate[way] = latency[way].worst == 0;
    to.arrival[way] = {now_ + latency[way].best, now_ + latency[way].worst};
  }
}

void Referee::put(const Event& event) {
  const ThreadId thread = ThreadId::of(event.actor);
  Party& of = party(thread);
  demand(!slot(ChannelId::of(event.subject)).full, "a message is put into a slot that is full");
  demand(wanted(ChannelId::of(event.subject)), "a message is put that no party waits for");
  const Step& step = step_of(thread);
  demand(step.kind == Step::Kind::send && step.channels.front() == ChannelId::of(event.subject) && !of.acted,
         name(thread), " sends what it does not send here");
  if (of.mode != Mode::sending) check_work(thread);
  of.acted = true;
  if (of.mode == Mode::running) midway_ = thread;
  monitor_.uses(thread, of.step);
  monitor_.puts(thread, ChannelId::of(event.subject));
  fill(ChannelId::of(event.subject), thread_of(thread).processor);
  asks(ChannelId::of(event.subject), thread);
}

void Referee::take(const Event& event) {
  const auto thread = ThreadId::of(event.actor);
  Party& of = party(thread);
  check_work(thread);
  demand(step_of(thread).kind == Step::Kind::wait && !of.gives_up && !of.acted && !of.withdrawn &&
             of.claim == ChannelId::of(event.subject) && slot(ChannelId::of(event.subject)).full,
         name(thread), " takes a message that is not its own");
  monitor_.takes(thread, ChannelId::of(event.subject));
  of.acted = true;
  midway_ = thread;
  empty(ChannelId::of(event.subject));
}

/// A message is taken, or withdrawn.
void Referee::empty(ChannelId channel) {
  Slot& of = slot(channel);
  if (of.answers)
    slot(channel_of(channel).answers).asked.erase(slot(channel_of(channel).answers).asked.begin());
  of.full = of.claimed = of.answers = of.to_be_dropped = false;
  of.from = ProcessorId{};
  of.emptied_by = at_;
  monitor_.empties(channel);
}

/// With an actor: the thread's message is not wanted. Without: the message in the slot is withdrawn.
void Referee::drop(const Event& event) {
  const auto actor = ThreadId::of(event.actor);
  const ChannelId channel = ChannelId::of(event.subject);
  if (event.actor >= 0) {
    demand(!wanted(channel), "a message is discarded that a party waits for");
    answered_in_vain(channel);
    Party& of = party(actor);
    const Step& step = step_of(actor);
    demand(step.kind == Step::Kind::send && step.channels.front() == channel && !of.acted, name(actor),
           " discards what it does not send");
    if (of.mode != Mode::sending) check_work(actor);
    of.acted = true;
    monitor_.uses(actor, of.step);
    return;
  }
  demand(channel.valid() && slot(channel).full, "nothing is there to withdraw");
  const ChannelId request = channel_of(channel).answer.valid() ? channel : channel_of(channel).answers;
  demand(request.valid(), "what is no request is withdrawn");
  if (!slot(channel).to_be_dropped) {
    // The effect of a wait that gives up has begun: all that is open goes at once.
    demand(!slot(request).given_up, "a request that is not open is withdrawn");
    midway_ = who_gives_up(request);
    for (const ChannelId awaited : step_of(midway_).channels) {
      const ChannelId asked = channel_of(awaited).answers;
      if (!asked.valid()) continue;
      withdraw(asked, std::nullopt);
      slot(asked).given_up = true;
    }
    demand(slot(channel).to_be_dropped, "a message that answers no open request is withdrawn");
  }
  dropped_at_ = now_;
  claim_withdrawn(channel);
  if (slot(channel).claimed) {
    for (Party& each : threads_) {
      if (each.claim == channel && each.mode != Mode::off) each.withdrawn = true;
    }
  }
  // A thread that has not begun to receive it yet still has its turn, and comes to the wait again then.
  monitor_.withdrawn(channel);
  if (channel == request) slot(request).asked.pop_back();
  empty(channel);
}

/// A thread that goes on at this instant after waiting for a message that is withdrawn had it already, unless
/// it takes what comes later. With a put a thread has stopped waiting, also if the message is withdrawn at
/// once.
void Referee::claim_withdrawn(ChannelId channel) {
  const bool put_for_a_thread = !slot(channel).there_again;
  const auto each_waiting = [&](const auto& visit) {
    for (const ThreadId thread : threads_.ids()) {
      if (slot(channel).claimed) break;
      if (threads_[thread].mode != Mode::waiting) continue;
      const std::vector<ChannelId>& channels = step_of(thread).channels;
      if (std::find(channels.begin(), channels.end(), channel) != channels.end()) visit(thread);
    }
  };
  each_waiting([&](ThreadId thread) {
    if (goes_on(thread) && !takes_next(thread)) resolve(thread);
  });
  each_waiting([&](ThreadId thread) {
    if (put_for_a_thread && goes_on(thread) && surely_there(channel, thread)) resolve(thread);
  });
  each_waiting([&](ThreadId thread) {
    demand(!put_for_a_thread || !surely_there(channel, thread), name(thread),
           " waits for a message that is there");
  });
}

/// The thread that has given up waiting for an answer to the request, and whose test is done now; of several
/// the next that is.
ThreadId Referee::who_gives_up(ChannelId request) const {
  for (std::size_t e = at_ + 1; e < events_.size() && events_[e].time_ns == now_; ++e) {
    const ThreadId thread = ThreadId::of(events_[e].actor);
    const bool is_done = events_[e].kind == Kind::done && thread.valid();
    if (!is_done || thread >= ThreadId(threads_.size())) continue;
    const Party& of = party(thread);
    if (of.mode != Mode::running || !of.gives_up) continue;
    const std::vector<ChannelId>& channels = step_of(thread).channels;
    const bool asked = std::any_of(channels.begin(), channels.end(),
                                   [&](ChannelId channel) { return channel_of(channel).answers == request; });
    if (asked) return thread;
  }
  broken("a message is withdrawn, but no thread gives up");
}

/// The actor's first event behind event `after`; behind the last: how many events there are.
std::size_t Referee::next_of(int actor, std::size_t after) const {
  const std::vector<std::size_t>& own = events_of_[static_cast<std::size_t>(actor)];
  const auto next = std::upper_bound(own.begin(), own.end(), after);
  return next == own.end() ? events_.size() : *next;
}

/// Whether a thread that waits stops waiting at this instant.
bool Referee::goes_on(ThreadId thread) const {
  const std::size_t next = next_of(thread.value, at_);
  if (next == events_.size() || events_[next].time_ns != now_) return false;
  return events_[next].kind == Kind::ready || events_[next].kind == Kind::start;
}

/// Whether a thread that stops waiting takes a message then, and does not come to its wait again.
bool Referee::takes_next(ThreadId thread) const {
  bool started = false;
  bool stopped = false;
  for (std::size_t e = next_of(thread.value, at_); e < events_.size(); e = next_of(thread.value, e)) {
    const Event& event = events_[e];
    if (event.kind == Kind::take) return true;
    const bool again = event.kind == Kind::start && started && !stopped;
    if (again || event.kind == Kind::block || event.kind == Kind::cancel) return false;
    started = started || event.kind == Kind::start;
    stopped = event.kind == Kind::stop;
  }
  return false;
}

}  // namespace pal::analyzer::run_checker
