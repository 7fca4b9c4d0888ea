// What follows at one instant from what has happened at it, in every order that can make a difference.
#include <algorithm>

#include "analyzer/machine/firing.hpp"

namespace pal::analyzer {

void Firing::all_due() {
  while (!due_.empty() && !state_.ended) {
    const std::vector<std::size_t> rivals = rivals_of_due();
    const std::size_t chosen =
        rivals[rivals.size() == 1 ? 0
                                  : static_cast<std::size_t>(choices_.pick(static_cast<int>(rivals.size())))];
    const Due due = due_[chosen];
    due_.erase(due_.begin() + static_cast<std::ptrdiff_t>(chosen));
    happen(due);
  }
}

void Firing::happen(const Due& due) {
  switch (due.what) {
    case Due::What::go_on:
      return finish(ThreadId::of(due.who), due.next);
    case Due::What::queue:
      enqueue(ThreadId::of(due.who), false);
      queued_.push_back(ThreadId::of(due.who));
      return;
    case Due::What::admit:
      return admit(ChannelId::of(due.who));
    case Due::What::parent:
      return go_on_behind_blocks(ThreadId::of(due.who));
    case Due::What::answer:
      return answer(ChannelId::of(due.who), due.carries);
    case Due::What::serve:
      return take_pending(DeviceId::of(due.who));
  }
}

void Firing::go_on_later(ThreadId thread, StepId next) {
  due_.push_back({Due::What::go_on, thread.value, next});
}

void Firing::queue_later(ThreadId thread) {
  due_.push_back({Due::What::queue, thread.value});
}

void Firing::admit_later(ChannelId channel) {
  if (somebody_sends(channel)) due_.push_back({Due::What::admit, channel.value});
}

/// The thread has been stopped.
void Firing::forget(ThreadId thread) {
  std::erase_if(due_, [thread](const Due& due) {
    const bool of_thread =
        due.what == Due::What::go_on || due.what == Due::What::queue || due.what == Due::What::parent;
    return of_thread && ThreadId::of(due.who) == thread;
  });
}

/// Whether nothing else that is due notices when it happens.
bool Firing::orderless(const Due& due) const {
  if (phase_may_change()) return false;
  if (due.what == Due::What::go_on) return keeps_processor(due) && !may_be_stopped(due);
  if (due.what == Due::What::serve) {
    const std::vector<ChannelId>& requests = problem_.devices[DeviceId::of(due.who)].requests;
    return std::none_of(requests.begin(), requests.end(),
                        [this](ChannelId request) { return somebody_sends(request); });
  }
  if (due.what != Due::What::answer || awaits_response(channel_of(ChannelId::of(due.who)).answer))
    return false;
  const bool alone =
      std::all_of(due_.begin(), due_.end(), [](const Due& other) { return other.what == Due::What::answer; });
  return alone && !meets_other_answers(due);
}

/// Whether a thread that waits for the answer waits for another that is due, or comes to the queue of one
/// that does.
bool Firing::meets_other_answers(const Due& due) const {
  std::set<Queue> queues;
  const std::vector<ThreadId> waiting = waiting_for(channel_of(ChannelId::of(due.who)).answer);
  for (const ThreadId thread : waiting)
    queues.emplace(thread_of(thread).processor, thread_of(thread).priority);
  if (queues.empty()) return false;
  return std::any_of(due_.begin(), due_.end(), [&](const Due& other) {
    if (&other == &due) return false;
    const std::vector<ThreadId> others = waiting_for(channel_of(ChannelId::of(other.who)).answer);
    return std::any_of(others.begin(), others.end(), [&](ThreadId thread) {
      return queues.contains({thread_of(thread).processor, thread_of(thread).priority});
    });
  });
}

/// A thread goes on with its next action.
bool Firing::keeps_processor(const Due& due) const {
  const Step::Kind after = problem_.steps[due.next].kind;
  return state_of(ThreadId::of(due.who)).status == Status::running && after != Step::Kind::wait &&
         after != Step::Kind::fork && after != Step::Kind::end;
}

/// Whether the thread, in a block that cannot end, stops here: what else is due may end the others. Then what
/// it has asked for is withdrawn, and its parent goes on.
bool Firing::may_be_stopped(const Due& due) const {
  if (state_of(ThreadId::of(due.who)).cancelled) return true;
  const bool alone = std::all_of(due_.begin(), due_.end(), [&due](const Due& other) {
    return &other == &due || other.what == Due::What::queue || other.what == Due::What::answer;
  });
  if (alone) return false;
  for (ThreadId thread = ThreadId::of(due.who); thread.valid(); thread = thread_of(thread).parent) {
    if (thread_of(thread).parent.valid() && !thread_of(thread).can_end) return true;
  }
  return false;
}

/// The queue that a thread comes to, if that is all that happens.
std::optional<Firing::Queue> Firing::only_queue(const Due& due) const {
  if (due.what != Due::What::queue && due.what != Due::What::go_on) return std::nullopt;
  if (changes_phase(due)) return std::nullopt;
  if (due.what == Due::What::go_on) {
    if (state_of(ThreadId::of(due.who)).status == Status::running ||
        state_of(ThreadId::of(due.who)).cancelled)
      return std::nullopt;
    const Step::Kind after = problem_.steps[due.next].kind;
    if (after == Step::Kind::wait || after == Step::Kind::fork || after == Step::Kind::end)
      return std::nullopt;
  }
  return std::pair(thread_of(ThreadId::of(due.who)).processor, thread_of(ThreadId::of(due.who)).priority);
}

/// Which may be the next to happen: positions in due_.
std::vector<std::size_t> Firing::rivals_of_due() const {
  std::vector<std::size_t> rivals;
  for (std::size_t i = 0; i < due_.size(); ++i) {
    if (!orderless(due_[i])) rivals.push_back(i);
  }
  if (rivals.empty()) return {0};
  const auto queue_of = [this](std::size_t i) { return only_queue(due_[i]); };
  const auto queues = [&](std::size_t i) { return queue_of(i).has_value(); };
  // Threads that come to queues meet only in the same one, and none that begins to wait.
  if (std::all_of(rivals.begin(), rivals.end(), queues)) {
    const auto first = queue_of(rivals.front());
    std::erase_if(rivals, [&](std::size_t i) { return queue_of(i) != first; });
    return rivals;
  }
  const auto begins_to_wait = [this](std::size_t i) {
    const Due& due = due_[i];
    return due.what == Due::What::go_on && state_of(ThreadId::of(due.who)).status == Status::running &&
           !state_of(ThreadId::of(due.who)).cancelled && !changes_phase(due) &&
           problem_.steps[due.next].kind == Step::Kind::wait;
  };
  const bool apart = rivals.size() == 2 && ((queues(rivals[0]) && begins_to_wait(rivals[1])) ||
                                            (begins_to_wait(rivals[0]) && queues(rivals[1])));
  if (apart) rivals.pop_back();
  return rivals;
}

}  // namespace pal::analyzer
