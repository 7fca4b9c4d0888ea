// Requests whose answers are still to come: to whom they belong, and how they are withdrawn.
#include "analyzer/machine/firing.hpp"

namespace pal::analyzer {

/// Whether the messages of the channel are requests that a party answers.
bool Firing::tracked(ChannelId channel) const {
  const Channel& of = channel_of(channel);
  return of.answer.valid() && (!of.receiver_device.valid() || of.served);
}

/// A request was put, by a thread or, without one, by a device.
void Firing::ask(ChannelId request, ThreadId thread) {
  if (!tracked(request)) return;
  Asked& asked = slot(request).asked;
  if (asked.count == Asked::most) {
    outcome_.too_many = true;
  } else {
    asked.push(thread.valid() ? number_of(thread) : Asked::device);
  }
}

/// Whether the request at place `at` is still in its slot.
bool Firing::in_slot(ChannelId request, int at) const {
  const SlotState& of = state_.slots[request];
  return of.fill != SlotState::Fill::empty && at + 1 == of.asked.count;
}

/// The place of the request that the next message of the channel answers; -1: it answers none.
int Firing::answered_next(ChannelId answer) const {
  const ChannelId request = channel_of(answer).answers;
  if (!request.valid()) return -1;
  const int at = state_.slots[answer].answers ? 1 : 0;
  const Asked& asked = state_.slots[request].asked;
  return at < asked.count && !in_slot(request, at) ? at : -1;
}

/// Whether no thread wants the next message of the channel.
bool Firing::discards(ChannelId answer) const {
  const int at = answered_next(answer);
  if (at < 0) return false;
  const Asked& asked = state_.slots[channel_of(answer).answers].asked;
  return asked.by[static_cast<std::size_t>(at)] == Asked::withdrawn;
}

/// A message that answers a request does not get into its slot.
void Firing::discard(ChannelId answer) {
  const int at = answered_next(answer);
  if (at >= 0) slot(channel_of(answer).answers).asked.erase(at);
}

/// Withdraws the open requests whose owner is meant. admit() is still to be called for the channels that
/// `freed` gets.
template <class Meant>
void Firing::withdraw(ChannelId request, Meant meant, std::vector<ChannelId>& freed) {
  Asked& asked = slot(request).asked;
  const ChannelId answer = channel_of(request).answer;
  // What is asked for from here on, by a sender whose slot becomes free, is not meant.
  for (int at = asked.count - 1; at >= 0; --at) {
    ThreadNumber& owner = asked.by[static_cast<std::size_t>(at)];
    if (owner == Asked::withdrawn || !meant(owner)) continue;
    const bool asking = in_slot(request, at);
    const bool answered = at == 0 && slot(answer).answers;
    if (asking || answered) {
      const ChannelId channel = asking ? request : answer;
      asked.erase(at);
      drop(channel);
      freed.push_back(channel);
    } else {
      owner = Asked::withdrawn;
    }
  }
}

void Firing::withdraw_all(ChannelId request, std::vector<ChannelId>& freed) {
  withdraw(
      request, [](ThreadNumber) { return true; }, freed);
}

/// What a block that has ended has open is its parent's.
void Firing::hand_over(ThreadId block, ThreadId parent) {
  for (SlotState& of : state_.slots) {
    for (std::size_t i = 0; i < of.asked.count; ++i) {
      if (of.asked.by[i] == number_of(block)) of.asked.by[i] = number_of(parent);
    }
  }
}

/// Whether a message answers a request of `owner` that is open.
bool Firing::answers_to(ChannelId channel, ThreadId owner) const {
  const ChannelId request = channel_of(channel).answers;
  if (!request.valid() || !state_.slots[channel].answers) return false;
  return state_.slots[request].asked.by.front() == number_of(owner);
}

/// A stopped thread leaves nothing behind: what it was to take is there for others, what it asked for is not.
/// If both are one message, it goes to another thread before it is withdrawn, or it does not. admit() is
/// still to be called for the channels that are free now.
std::vector<ChannelId> Firing::abandon(ThreadId thread) {
  const ThreadState& state = state_of(thread);
  // A block that is stopped before it has begun is at no step yet; one with a choice is at a wait.
  if (state.choice >= 0 && !step_of(thread).channels.empty()) {
    const ChannelId channel = step_of(thread).channels[static_cast<std::size_t>(state.choice)];
    if (slot(channel).fill == SlotState::Fill::claimed) {
      slot(channel).fill = SlotState::Fill::full;
      const bool goes_first =
          !answers_to(channel, thread) || waiting_for(channel).empty() || choices_.pick(2) == 0;
      const ThreadId other = goes_first ? claimed_by(channel) : ThreadId{};
      if (other.valid()) queue_later(other);
    }
  }
  std::vector<ChannelId> freed;
  for (const ChannelId c : problem_.channels.ids()) {
    withdraw(
        c, [thread](ThreadNumber owner) { return owner == number_of(thread); }, freed);
  }
  return freed;
}

}  // namespace pal::analyzer
