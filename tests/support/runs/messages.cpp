// Messages: slots, and the threads that wait for them.
#include "tests/support/runs/all_runs.hpp"

#include <algorithm>

namespace pal::test {

using namespace pan;
using namespace runs;

bool AllRuns::available(int channel, int thread) const {
  const Slot& slot = s_.slots[ix(channel)];
  if (!slot.full || slot.claimed >= 0) return false;
  if (slot.from < 0) return true;
  return (slot.from == s_.threads[ix(thread)].processor ? slot.near : slot.far) < 0;
}

void AllRuns::put(int channel, int thread, int process, int carries) {
  Slot& slot = s_.slots[ix(channel)];
  if (process >= 0 && slot.full) {
    say(processes_[ix(process)].name + " overruns");
    if (wanted_.events.count(channel) != 0 && in_question()) s_.failed = true;
    answered_in_vain(channel);
    return;
  }
  say((thread >= 0 ? who(thread) : processes_[ix(process)].name) + " puts " +
      network_.messages[network_.channels[ix(channel)].message.index()].name);
  slot.full = true;
  slot.claimed = -1;
  slot.carries = carries;
  if (wanted_.events.count(channel) != 0) {
    slot.carries = birth();
    if (!in_question()) s_.births.back() = -1;
  }
  slot.near = slot.far = -1;
  slot.from = thread < 0 ? -1 : s_.threads[ix(thread)].processor;
  slot.answers = answered_next(channel).has_value();
  if (answered(channel)) slot.asked.push_back({thread, false});
  if (receiver_process_[ix(channel)] >= 0) return;
  if (thread < 0) return;
  // A way of no length may be over before anything else happens, as if there were no latency.
  const auto fly = [&](Interval latency) {
    const int way = latency.worst.count() == 0 ? -1 : draw(latency);
    return way == 0 && decisions_->pick(2) == 1 ? -1 : way;
  };
  slot.near = fly(environment_.latency.within_processor);
  slot.far = fly(environment_.latency.between_processors);
}

/// One of those that wait for the message, if any, stops waiting; it has to come to its queue yet.
int AllRuns::claim(int channel) {
  std::vector<std::pair<int, int>> waiting;
  for (std::size_t t = 0; t < s_.threads.size(); ++t) {
    const Thread& thread = s_.threads[t];
    if (thread.status != Status::waiting || !available(channel, static_cast<int>(t))) continue;
    const auto& channels = std::get<Wait>(node(thread).content).channels;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      if (channels[i].value == channel) waiting.push_back({static_cast<int>(t), static_cast<int>(i)});
    }
  }
  if (waiting.empty()) return -1;
  const auto [thread, which] =
      waiting[ix(waiting.size() == 1 ? 0 : decisions_->pick(static_cast<int>(waiting.size())))];
  s_.slots[ix(channel)].claimed = thread;
  Thread& of = s_.threads[ix(thread)];
  of.claim = which;
  of.begun = false;
  of.limit = -1;
  of.status = Status::ready;
  return thread;
}

void AllRuns::offer(int channel) {
  const int thread = claim(channel);
  if (thread >= 0) ready(thread);
}

bool AllRuns::somebody_sends(int channel) const {
  for (const Thread& thread : s_.threads) {
    if (thread.status == Status::sending && std::get<Send>(node(thread).content).channel.value == channel)
      return true;
  }
  return false;
}

/// The slot, empty now, is there for a sender that is blocked.
void AllRuns::emptied(int channel) {
  if (s_.slots[ix(channel)].full) return;
  std::vector<int> senders;
  for (std::size_t t = 0; t < s_.threads.size(); ++t) {
    if (s_.threads[t].status == Status::sending &&
        std::get<Send>(node(s_.threads[t]).content).channel.value == channel)
      senders.push_back(static_cast<int>(t));
  }
  if (senders.empty()) return;
  send_done(senders[ix(senders.size() == 1 ? 0 : decisions_->pick(static_cast<int>(senders.size())))]);
}

/// The effect of a send, at once or of a sender that was blocked.
void AllRuns::send_done(int thread) {
  Thread& of = s_.threads[ix(thread)];
  if (of.status == Status::sending) of.status = Status::ready;  // and in no queue yet
  const int channel = std::get<Send>(node(of).content).channel.value;
  uses(thread, {network_.channels[ix(channel)].message});
  if (discards(channel)) {
    answered_in_vain(channel);
    say(who(thread) + " discards");
    measure(thread);
    const bool more = somebody_sends(channel);
    goes_on(thread, 0);
    if (more) later([this, channel] { emptied(channel); });
    return;
  }
  put(channel, thread, -1, sent_along(thread));
  measure(thread);
  const int process = receiver_process_[ix(channel)];
  if (process >= 0) {
    take_request(process, channel);
  } else {
    comes_to_its_queue(claim(channel));
  }
  goes_on(thread, 0);
}

/// A thread whose statement is over: with what else follows from it, unless it is to stop. A statement that a
/// cancelled block finishes has its whole effect before it stops.
void AllRuns::goes_on(int thread, std::size_t out) {
  if (s_.threads[ix(thread)].cancelled) {
    proceed(thread, out);
  } else {
    later([this, thread, out] { proceed(thread, out); });
  }
}

/// Unless it was stopped meanwhile, and has perhaps begun again.
void AllRuns::comes_to_its_queue(int thread) {
  if (thread < 0) return;
  const int turn = s_.threads[ix(thread)].turn = ++turns_;
  later([this, thread, turn] {
    if (s_.threads[ix(thread)].turn == turn) ready(thread);
  });
}

void AllRuns::take(int channel, int thread) {
  if (thread >= 0) has_taken(thread, channel);
  if (!s_.slots[ix(channel)].answers) return;
  std::vector<Asked>& asked = s_.slots[ix(request_of_[ix(channel)])].asked;
  asked.erase(asked.begin());
}

/// The slot is empty; emptied() is still to be called.
void AllRuns::clear(int channel) {
  Slot& slot = s_.slots[ix(channel)];
  slot.full = slot.answers = false;
  slot.claimed = slot.from = slot.near = slot.far = slot.carries = slot.later = -1;
}

}  // namespace pal::test
