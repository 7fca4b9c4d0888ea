// The threads that have the processors, and those that wait for them.
#include "analyzer/run_checker/referee.hpp"

#include <algorithm>

namespace pal::analyzer::run_checker {

void Referee::hold(ThreadId thread) {
  holder(thread) = thread;
  monitor_.busy(thread_of(thread).processor);
}

void Referee::release(ThreadId thread) {
  if (holder(thread) == thread) {
    holder(thread) = ThreadId{};
    monitor_.idle(thread_of(thread).processor);
  }
  std::erase_if(queue_, [thread](const Queued& queued) { return queued.thread == thread; });
}

void Referee::enqueue(ThreadId thread, bool front, bool ordered, std::size_t with) {
  const Queued made{thread, now_, effects_, ordered, with, front, false, false};
  queue_.insert(front ? queue_.begin() : queue_.end(), made);
}

/// If it finds there what it waits for, or only looks, this is its place in the queue.
void Referee::arrive(ThreadId thread) {
  if (holder(thread) == thread) return;
  enqueue(thread, false, !beginning_ && !withdrawing_, with_);
  queue_.back().arrived = true;
}

/// Whether a thread that has come to a wait found the message of the channel as it did.
bool Referee::found_there(ThreadId thread, ChannelId channel) const {
  return surely_there(channel, thread) && slot(channel).put_by < party(thread).reached_by;
}

/// Of a thread that has come to a wait: whether it did so to go on at once.
bool Referee::comes_to_queue(const Queued& queued) const {
  if (!queued.arrived) return true;
  const Step& at = step_of(queued.thread);
  if (at.within && *at.within == 0) return true;
  const bool there = std::any_of(at.channels.begin(), at.channels.end(),
                                 [&](ChannelId channel) { return found_there(queued.thread, channel); });
  return there && goes_on(queued.thread);
}

/// A thread that was waiting, or has come to a wait, does not wait any more: a message has come.
void Referee::resolve(ThreadId thread) {
  Party& of = party(thread);
  if (of.mode != Mode::arrived && of.mode != Mode::waiting) return;
  const Step& at = step_of(thread);
  const bool waited = of.mode == Mode::waiting;
  bool at_once = !waited && at.within && *at.within == 0;
  if (!of.gives_up) {
    std::vector<ChannelId> candidates;
    for (ChannelId channel : at.channels) {
      const Slot& from = slot(channel);
      if (!from.full || from.claimed) continue;
      const Arrival& there = arrival(channel, thread);
      if (there.lo <= now_ && (!waited || now_ <= there.hi)) candidates.push_back(channel);
    }
    demand(!candidates.empty(), name(thread), " goes on without a message");
    const ChannelId channel = message_of(thread, candidates);
    for (ChannelId earlier : at.channels) {
      if (earlier == channel) break;
      // A sender that became free after the thread had chosen may have filled the slot meanwhile.
      const bool came_after = slot(earlier).put_by > of.reached_by &&
                              slot(earlier).emptied_by <= of.reached_by &&
                              slot(channel).put_by < of.reached_by;
      if (!waited && !came_after) not_there_yet(earlier, thread);
    }
    at_once = at_once || (!waited && found_there(thread, channel));
    Arrival& there = arrival(channel, thread);
    if (waited) there.lo = now_;
    there.hi = std::min(there.hi, now_);
    slot(channel).claimed = true;
    of.claim = channel;
  }
  of.mode = Mode::ready;
  const auto place =
      std::find_if(queue_.begin(), queue_.end(), [thread](const Queued& q) { return q.thread == thread; });
  if (at_once && place != queue_.end()) {
    place->arrived = false;
    return;
  }
  if (place != queue_.end()) queue_.erase(place);
  if (holder(thread) != thread) enqueue(thread, false, false, 0);
}

/// Whose message was withdrawn comes to its wait again at the effect.
void Referee::again(ThreadId thread) {
  Party& of = party(thread);
  if (of.mode != Mode::running || !of.withdrawn) return;
  check_work(thread);
  demand(!of.must_stop, name(thread), " goes on although it is cancelled");
  reach(thread, of.step);
}

void Referee::was_ready(const Event& event) {
  const auto actor = ThreadId::of(event.actor);
  again(actor);
  resolve(actor);
  demand(party(actor).mode == Mode::ready, name(actor), " is not ready");
  demand(holder(actor) != actor, name(actor), " has its processor");
  const auto own = std::find_if(queue_.begin(), queue_.end(),
                                [&](const Queued& queued) { return queued.thread == actor; });
  demand(own != queue_.end() && own->at == now_ && !own->told, name(actor), " was ready before");
  own->told = true;
}

void Referee::check_turn(ThreadId thread) const {
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
    if (rival.processor != of.processor || !comes_to_queue(*other)) continue;
    demand(rival.priority <= of.priority, of.name, " runs before ", rival.name,
           ", whose priority is greater");
    if (rival.priority < of.priority || !before || own == queue_.end()) continue;
    const bool together = other->at == own->at && other->after == own->after;
    const bool in_order = (other->ordered && own->ordered) || (own->with != 0 && other->with == own->with);
    const bool either = !other->front && !own->front && together && !in_order;
    demand(either, of.name, " runs before ", rival.name, ", which was first");
  }
}

void Referee::started(const Event& event) {
  const ThreadId thread = ThreadId::of(event.actor);
  again(thread);
  resolve(thread);
  Party& of = party(thread);
  demand(of.mode == Mode::ready || of.mode == Mode::stopped, name(thread), " starts what it cannot start");
  demand(of.mode == Mode::stopped || !of.must_stop, name(thread), " is cancelled and goes on");
  ThreadId& loser = preempted_[thread_of(thread).processor];
  demand(!loser.valid() || thread_of(thread).priority > thread_of(loser).priority,
         "a thread is stopped for nothing");
  loser = ThreadId{};
  ThreadId& has = holder(thread);
  if (has != thread) {
    if (has.valid()) {
      const ThreadId before = has;
      resolve(before);
      const pan::Processor& processor = problem_.processors[thread_of(thread).processor];
      demand(party(before).mode == Mode::ready, name(thread), " starts while ", name(before), " runs");
      demand(processor.preemptive && thread_of(thread).priority > thread_of(before).priority, name(thread),
             " takes the processor that ", name(before), " keeps");
      has = ThreadId{};
      enqueue(before, true, true, 0);
    }
    check_turn(thread);
    release(thread);
    hold(thread);
  } else {
    const bool preemptive = problem_.processors[thread_of(thread).processor].preemptive;
    for (const Queued& queued : queue_) {
      const Thread& rival = thread_of(queued.thread);
      const bool first = preemptive && rival.processor == thread_of(thread).processor &&
                         rival.priority > thread_of(thread).priority && comes_to_queue(queued);
      demand(!first, name(thread), " runs before ", rival.name, ", whose priority is greater");
    }
  }
  of.mode = Mode::running;
  of.since = now_;
}

void Referee::stopped(const Event& event) {
  const auto thread = ThreadId::of(event.actor);
  Party& of = party(thread);
  demand(of.mode == Mode::running, name(thread), " is stopped without running");
  demand(!of.acted && of.reads.empty(), name(thread), " is interrupted in its effect");
  demand(problem_.processors[thread_of(thread).processor].preemptive, name(thread),
         " is preempted on a processor that does not");
  of.work += now_ - of.since;
  of.mode = Mode::stopped;
  preempted_[thread_of(thread).processor] = thread;
  holder(thread) = ThreadId{};
  enqueue(thread, true, true, 0);
}

void Referee::check_work(ThreadId thread) const {
  const Party& of = party(thread);
  demand(of.mode == Mode::running, name(thread), " has an effect without running");
  const Nanoseconds work = of.work + now_ - of.since;
  demand(work >= cost(thread).best, name(thread), " is done after too little processor time");
  demand(work <= cost(thread).worst, name(thread), " is done after too much processor time");
}

Range Referee::cost(ThreadId thread) const {
  return party(thread).gives_up ? step_of(thread).give_up_cost : step_of(thread).cost;
}

}  // namespace pal::analyzer::run_checker
