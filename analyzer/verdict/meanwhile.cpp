// What another thread did while one waited for it.
#include "analyzer/verdict/narrator.hpp"

#include <algorithm>

namespace pal::analyzer {

/// What the thread that ended a wait, or is to end it, did in [from, to]. Nothing if there is none, or if it
/// was not at work.
std::vector<Reason> Narrator::meanwhile(const trace::Slice& wait, Nanoseconds from, Nanoseconds to,
                                        int depth) const {
  const bool goes_on = wait.to_ns > to || wait.ending == trace::Ending::open;
  if (from >= to || (!goes_on && wait.ending != trace::Ending::over)) return {};
  std::vector<Reason> pieces;
  if (wait.channel < 0) {
    const ThreadId block = goes_on ? ThreadId{} : last_block(ThreadId::of(wait.actor), from, to);
    if (block.valid()) tell(block, from, to, pieces, depth);
    return pieces;
  }
  const std::optional<int> other = goes_on ? to_send(wait) : waited_for(wait);
  if (!other || *other == wait.actor) return {};
  // A message may be on its way for a while.
  const auto put = goes_on || is_send(wait) ? std::nullopt : put_for(wait);
  const Nanoseconds sent = put ? std::min<Nanoseconds>(run_.events[*put].time_ns, to) : to;
  if (from < sent && is_device(*other)) {
    serves(*other, from, sent, pieces);
  } else if (from < sent) {
    tell(ThreadId::of(*other), from, sent, pieces, depth);
  }
  if (sent == to || (pieces.empty() && from < sent)) return pieces;
  const auto channel = static_cast<std::size_t>(put ? run_.events[*put].subject : wait.channel);
  const std::string& message = run_.channels[channel].message;
  pieces.push_back(reason(std::max(from, sent), to, -1, message + " is on its way", -1));
  return pieces;
}

/// Whether it is a wait for room.
bool Narrator::is_send(const trace::Slice& wait) const {
  return wait.statement >= 0 && sends_[StatementId::of(wait.statement)];
}

/// The party that is to send what a wait is for, if that is one thread or device.
std::optional<int> Narrator::to_send(const trace::Slice& wait) const {
  if (wait.statement < 0 || is_send(wait)) return std::nullopt;
  const std::string& sender = run_.channels[static_cast<std::size_t>(wait.channel)].sender;
  const auto actor = std::find_if(run_.actors.begin(), run_.actors.end(),
                                  [&](const trace::Actor& each) { return each.name == sender; });
  if (actor == run_.actors.end()) return std::nullopt;
  return static_cast<int>(actor - run_.actors.begin());
}

/// The party that ended a wait: it put the message at that instant, or made room for one.
std::optional<int> Narrator::waited_for(const trace::Slice& wait) const {
  if (!is_send(wait)) return sender_at(wait);
  for (std::size_t actor = 0; actor < takes_.size(); ++actor) {
    const auto first = first_at(takes_[actor], wait.to_ns);
    const bool made_room = std::any_of(first, takes_[actor].end(), [&](std::size_t e) {
      return run_.events[e].time_ns == wait.to_ns && run_.events[e].subject == wait.channel;
    });
    if (made_room) return static_cast<int>(actor);
  }
  return std::nullopt;
}

/// The party that put what the wait was for.
std::optional<int> Narrator::sender_at(const trace::Slice& wait) const {
  const auto put = put_for(wait);
  return put ? std::optional(run_.events[*put].actor) : std::nullopt;
}

/// The put of what is taken after a wait for a message that came.
std::optional<std::size_t> Narrator::put_for(const trace::Slice& wait) const {
  const std::vector<std::size_t>& own = takes_[static_cast<std::size_t>(wait.actor)];
  const auto take = first_at(own, wait.to_ns);
  const auto put = take == own.end() ? put_of_.end() : put_of_.find(*take);
  return put == put_of_.end() ? std::nullopt : std::optional(put->second);
}

/// The first of these events that is not before an instant.
std::vector<std::size_t>::const_iterator Narrator::first_at(const std::vector<std::size_t>& events,
                                                            Nanoseconds instant) const {
  return std::partition_point(events.begin(), events.end(),
                              [&](std::size_t e) { return run_.events[e].time_ns < instant; });
}

/// Of the blocks of a thread the one that works to the end of [from, to].
ThreadId Narrator::last_block(ThreadId thread, Nanoseconds from, Nanoseconds to) const {
  for (const ThreadId block : problem_.threads.ids()) {
    if (problem_.threads[block].parent != thread) continue;
    const std::vector<trace::Slice>& own = of_actor_[block.index()];
    const auto next = std::partition_point(own.begin(), own.end(),
                                           [to](const trace::Slice& slice) { return slice.to_ns < to; });
    if (next != own.end() && next->from_ns < to && next->to_ns == to && next->to_ns > from &&
        next->ending == trace::Ending::effect)
      return block;
  }
  return ThreadId{};
}

/// What a device did in [from, to]: nothing to tell of one that does not work.
void Narrator::serves(int device, Nanoseconds from, Nanoseconds to, std::vector<Reason>& out) const {
  Nanoseconds at = from;
  for (const trace::Slice& slice : of_actor_[static_cast<std::size_t>(device)]) {
    if (slice.to_ns <= at || slice.from_ns >= to) continue;
    if (slice.from_ns > at) out.push_back(reason(at, slice.from_ns, device, "is not at work", -1));
    const Nanoseconds begin = std::max<Nanoseconds>(at, slice.from_ns);
    at = std::min<Nanoseconds>(to, slice.to_ns);
    out.push_back(reason(begin, at, device, works_on(device, slice), -1));
  }
  if (at < to && at > from) out.push_back(reason(at, to, device, "is not at work", -1));
}

/// What comes of a device's work.
std::string Narrator::works_on(int device, const trace::Slice& slice) const {
  const std::vector<std::size_t>& puts = puts_[static_cast<std::size_t>(device)];
  const auto put = first_at(puts, slice.to_ns);
  if (put == puts.end() || run_.events[*put].time_ns != slice.to_ns) return "works";
  return "works, and gives " + run_.channels[static_cast<std::size_t>(run_.events[*put].subject)].message;
}

}  // namespace pal::analyzer
