// Messages: slots, latencies, and requests that are withdrawn.
#include <algorithm>

#include "analyzer/replay/referee.hpp"

namespace pal::analyzer::rules {

Referee::Arrival& Referee::arrival(int channel, int thread) {
  Slot& of = slot(channel);
  return of.arrival[of.from == thread_of(thread).processor ? 0 : 1];
}

const Referee::Arrival& Referee::arrival(int channel, int thread) const {
  const Slot& of = slot(channel);
  return of.arrival[of.from == thread_of(thread).processor ? 0 : 1];
}

bool Referee::surely_there(int channel, int thread) const {
  const Slot& of = slot(channel);
  if (!of.full || of.claimed) return false;
  return of.immediate[of.from == thread_of(thread).processor ? 0 : 1] || arrival(channel, thread).hi < now_;
}

/// A thread goes on as if the channel had nothing for it: what is there must still be on its way.
void Referee::not_there_yet(int channel, int thread) {
  demand(!surely_there(channel, thread), name(thread) + " passes over a message that is there");
  const Slot& of = slot(channel);
  if (of.full && !of.claimed) arrival(channel, thread).lo = std::max(arrival(channel, thread).lo, now_);
}

/// Which of several the thread takes in the end; the first, if the run does not say.
int Referee::message_of(int thread, const std::vector<int>& candidates) const {
  for (std::size_t e = at_; candidates.size() > 1 && e < events_.size(); ++e) {
    const Event& event = events_[e];
    const bool is = std::find(candidates.begin(), candidates.end(), event.subject) != candidates.end();
    if (event.kind == Kind::drop && event.actor < 0 && is) return event.subject;
    if (event.actor != thread) continue;
    if (event.kind == Kind::take) return is ? event.subject : candidates.front();
    if (event.kind == Kind::cancel) break;
  }
  return candidates.front();
}

void Referee::fill(int channel, int processor) {
  Slot& to = slot(channel);
  to.full = true;
  to.claimed = false;
  to.from = processor;
  to.put = now_;
  const Range none{0, 0};
  const bool flies = processor >= 0;
  const Range latency[2] = {flies ? problem_.within_processor : none,
                            flies ? problem_.between_processors : none};
  for (int way = 0; way < 2; ++way) {
    to.immediate[way] = latency[way].worst == 0;
    to.arrival[way] = {now_ + latency[way].best, now_ + latency[way].worst};
  }
}

void Referee::put(const Event& event) {
  const int thread = event.actor;
  Party& of = party(thread);
  Slot& to = slot(event.subject);
  demand(!to.full, "a message is put into a slot that is full");
  demand(to.unwanted == 0, "a message that nobody wants is put");
  bool along = false;
  if (of.owes_put == event.subject) {
    of.owes_put = -1;
  } else {
    const Step& step = step_of(thread);
    demand(step.kind == Step::Kind::send && step.channels.front() == event.subject && !of.acted,
           name(thread) + " sends what it does not send here");
    if (of.mode != Mode::sending) check_work(thread);
    of.acted = true;
    along = true;
  }
  gauge_.puts(thread, event.subject, along);
  fill(event.subject, thread_of(thread).processor);
  if (channel_of(event.subject).answer >= 0) {
    ++to.open;
    to.owner = thread;
  }
}

void Referee::take(const Event& event) {
  Party& of = party(event.actor);
  check_work(event.actor);
  demand(step_of(event.actor).kind == Step::Kind::wait && !of.gives_up && !of.acted && !of.withdrawn &&
             of.claim == event.subject && slot(event.subject).full,
         name(event.actor) + " takes a message that is not its own");
  gauge_.takes(event.actor, event.subject);
  of.acted = true;
  answer_taken(event.subject);
  empty(event.subject);
}

void Referee::answer_taken(int channel) {
  const int request = channel_of(channel).answers;
  if (request >= 0 && slot(request).open > 0) --slot(request).open;
}

void Referee::empty(int channel) {
  Slot& of = slot(channel);
  of.full = of.claimed = false;
  of.from = -1;
  gauge_.empties(channel);
}

/// By a thread: its message is not wanted. By nobody: somebody withdraws the message in the slot.
void Referee::drop(const Event& event) {
  const int channel = event.subject;
  if (event.actor >= 0) {
    Slot& to = slot(channel);
    demand(to.unwanted > 0, "a message that somebody wants is discarded");
    --to.unwanted;
    Party& of = party(event.actor);
    const Step& step = step_of(event.actor);
    demand(step.kind == Step::Kind::send && step.channels.front() == channel && !of.acted,
           name(event.actor) + " discards what it does not send");
    if (of.mode != Mode::sending) check_work(event.actor);
    of.acted = true;
    return;
  }
  demand(channel >= 0 && slot(channel).full, "nothing is there to withdraw");
  const bool is_request = channel_of(channel).answer >= 0;
  const int request = is_request ? channel : channel_of(channel).answers;
  demand(request >= 0, "what is no request is withdrawn");
  Slot& of = slot(request);
  demand(is_request || !of.full || of.put == now_, "an answer is withdrawn while its request waits");
  if (of.expected_drops > 0) {
    --of.expected_drops;
  } else {
    demand(of.open > 0, "a request that is not open is withdrawn");
    // All that is open goes at once: what is there is dropped, the rest discarded when it comes.
    const int drops = std::min(of.open, 1 + drops_that_follow(request));
    slot(channel_of(request).answer).unwanted += of.open - drops;
    of.expected_drops += drops - 1;
    of.open = 0;
    ++of.unexplained_drops;
  }
  // Whoever goes on at this instant after waiting for it had it already.
  for (std::size_t t = 0; t < threads_.size() && !slot(channel).claimed; ++t) {
    const int thread = static_cast<int>(t);
    if (threads_[t].mode != Mode::waiting || !goes_on(thread)) continue;
    const std::vector<int>& channels = step_of(thread).channels;
    if (std::find(channels.begin(), channels.end(), channel) != channels.end()) resolve(thread);
  }
  if (slot(channel).claimed) {
    for (Party& each : threads_) {
      if (each.claim == channel && each.mode != Mode::off) each.withdrawn = true;
    }
  }
  // A thread that has not begun to receive it yet still has its turn, and comes to the wait again then.
  gauge_.withdrawn(channel);
  empty(channel);
}

/// A wait for the answer was given up: what could be removed has been, the rest is discarded when it comes.
void Referee::withdraw_all(int request) {
  Slot& of = slot(request);
  if (of.unexplained_drops > 0) {
    of.unexplained_drops = 0;
    return;
  }
  slot(channel_of(request).answer).unwanted += of.open;
  if (of.open > 0) {
    const bool left = (of.full && of.put < now_) ||
                      (slot(channel_of(request).answer).full && slot(channel_of(request).answer).put < now_);
    demand(!left, "what was asked for and given up is still there");
  }
  of.open = 0;
}

/// Whether a thread that waits stops waiting at this instant.
bool Referee::goes_on(int thread) const {
  for (std::size_t e = at_ + 1; e < events_.size() && events_[e].time_ns == now_; ++e) {
    if (events_[e].actor != thread) continue;
    return events_[e].kind == Kind::ready || events_[e].kind == Kind::start;
  }
  return false;
}

int Referee::drops_that_follow(int request) const {
  int found = 0;
  for (std::size_t e = at_ + 1; e < events_.size() && events_[e].time_ns == now_; ++e) {
    const Event& event = events_[e];
    if (event.kind == Kind::cancel || event.kind == Kind::start || event.kind == Kind::ready) break;
    const bool of = event.subject == request || event.subject == channel_of(request).answer;
    if (event.kind == Kind::drop && event.actor < 0 && of) ++found;
  }
  return found;
}

/// What a stopped thread was to take is there for others; what it asked for is withdrawn.
void Referee::abandon(int thread) {
  Party& of = party(thread);
  if (of.claim >= 0 && !of.withdrawn && !of.acted && slot(of.claim).full && slot(of.claim).claimed) {
    slot(of.claim).claimed = false;
    for (Arrival& there : slot(of.claim).arrival) {
      if (there.hi < now_) there.lo = there.hi = now_;
    }
  }
  for (std::size_t c = 0; c < slots_.size(); ++c) {
    Slot& request = slots_[c];
    if (request.open == 0 || request.owner != thread) continue;
    const int drops = std::min(request.open, drops_that_follow(static_cast<int>(c)));
    const Slot& answer = slot(channel_of(static_cast<int>(c)).answer);
    demand(drops > 0 || (!request.full && !answer.full), "what a stopped thread asked for is still there");
    request.expected_drops += drops;
    slot(channel_of(static_cast<int>(c)).answer).unwanted += request.open - drops;
    request.open = 0;
  }
}

}  // namespace pal::analyzer::rules
