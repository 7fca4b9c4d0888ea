// Requests between their put and the take of their answer, and how they are withdrawn.
#include <algorithm>

#include "analyzer/run_checker/referee.hpp"

namespace pal::analyzer::run_checker {

/// A request was put. One to a device that answers nothing is never open.
void Referee::asks(ChannelId request, ThreadId owner) {
  const Channel& of = channel_of(request);
  if (!of.answer.valid() || (of.receiver_device.valid() && !of.served)) return;
  slot(request).asked.push_back({owner, false});
}

/// Which of the requests the next message of the channel answers: the oldest one that was taken and is not
/// answered yet.
std::optional<std::size_t> Referee::answered_next(ChannelId answer) const {
  const ChannelId request = channel_of(answer).answers;
  if (!request.valid()) return std::nullopt;
  const Slot& of = slot(request);
  const std::size_t taken = of.asked.size() - (of.full && !of.asked.empty() ? 1 : 0);
  const std::size_t next = slot(answer).answers ? 1 : 0;
  if (next >= taken) return std::nullopt;
  return next;
}

bool Referee::wanted(ChannelId answer) const {
  const auto next = answered_next(answer);
  return !next || !slot(channel_of(answer).answers).asked[*next].withdrawn;
}

/// The next message of the channel is lost or discarded.
void Referee::answered_in_vain(ChannelId answer) {
  const auto next = answered_next(answer);
  if (!next) return;
  std::vector<Asked>& asked = slot(channel_of(answer).answers).asked;
  asked.erase(asked.begin() + static_cast<std::ptrdiff_t>(*next));
}

/// What is open of a request, all of it or what belongs to one thread: the run has to drop what is in a slot.
void Referee::withdraw(ChannelId request, std::optional<ThreadId> owner) {
  Slot& of = slot(request);
  for (std::size_t i = 0; i < of.asked.size(); ++i) {
    if (of.asked[i].withdrawn || (owner && of.asked[i].owner != *owner)) continue;
    of.asked[i].withdrawn = true;
    if (of.full && i + 1 == of.asked.size()) {
      check_not_idle(request);
      of.to_be_dropped = true;
    } else if (i == 0 && slot(channel_of(request).answer).answers) {
      slot(channel_of(request).answer).to_be_dropped = true;
    }
  }
}

/// The effect of a wait that gives up. What it dropped came before.
void Referee::gives_up(ChannelId request) {
  if (slot(request).given_up) {
    slot(request).given_up = false;
    return;
  }
  withdraw(request, std::nullopt);
}

void Referee::hands_over(ThreadId block, ThreadId parent) {
  for (Slot& of : slots_) {
    for (Asked& each : of.asked) {
      if (each.owner == block) each.owner = parent;
    }
  }
}

/// What a stopped thread was to take is there for others; what it asked for is withdrawn.
void Referee::abandon(ThreadId thread) {
  Party& of = party(thread);
  if (of.claim.valid() && !of.withdrawn && !of.acted && slot(of.claim).full && slot(of.claim).claimed) {
    slot(of.claim).claimed = false;
    slot(of.claim).there_again = true;
    for (Arrival& there : slot(of.claim).arrival) {
      if (there.hi < now_) there.lo = there.hi = now_;
    }
  }
  for (const ChannelId c : slots_.ids()) withdraw(c, thread);
}

}  // namespace pal::analyzer::run_checker
