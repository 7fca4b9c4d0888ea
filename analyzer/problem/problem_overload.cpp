// Processors that have more to do for the events of the world than there is time.
#include <algorithm>
#include <functional>
#include <queue>

#include "analyzer/problem/flow.hpp"
#include "analyzer/problem/problem_builder.hpp"
#include "pal/support/finding.hpp"

namespace pal::analyzer {
namespace {

__extension__ using WideShare = __int128;
// Of the time that there is: so fine that a nanosecond in the longest period counts as far as numbers go.
constexpr WideShare whole_time = 1'000'000'000'000;
constexpr WideShare most_asked = 1'000 * whole_time;

/// Whether each channel brings the events of a device.
Table<ChannelId, bool> event_channels(const Problem& problem) {
  Table<ChannelId, bool> events(problem.channels.size());
  for (const Device& device : problem.devices) {
    const bool sends = std::holds_alternative<pan::EventDevice>(device.behaviour) && device.event.valid();
    if (sends) events[device.event] = true;
  }
  return events;
}

/// The least processor time from taking an event at `wait` until the thread waits for an event again, this or
/// another. Each action takes its worst time. Nothing if the thread never waits for an event again. E. W.
/// Dijkstra, A note on two problems in connexion with graphs, 1959.
std::optional<Nanoseconds> least_round(const Problem& problem, const Table<ChannelId, bool>& events,
                                       const Step& wait, std::size_t branch) {
  using Reached = std::pair<Nanoseconds, StepId>;
  Table<StepId, bool> done(problem.steps.size());
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  open.push({wait.cost.worst, wait.next[branch]});
  while (!open.empty()) {
    const auto [work, at] = open.top();
    open.pop();
    const Step& step = problem.steps[at];
    const bool waits = step.kind == Step::Kind::wait;
    const bool again = waits && std::any_of(step.channels.begin(), step.channels.end(),
                                            [&events](ChannelId c) { return events[c]; });
    if (again) return work;
    if (done[at]) continue;
    done[at] = true;
    for (std::size_t n = 0; n < step.next.size(); ++n) {
      const bool gives_up = waits && n >= step.channels.size();
      open.push({work + (gives_up ? step.give_up_cost.worst : step.cost.worst), step.next[n]});
    }
  }
  return std::nullopt;
}

/// The thread that takes the events of a channel, and the least that it has to do for one.
struct Taker {
  const Thread* thread = nullptr;
  bool alone = true;
  std::optional<Nanoseconds> round;
};

std::string percent(WideShare part) {
  const auto tenths = static_cast<Nanoseconds>(part * 1'000 / whole_time);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " %";
}

}  // namespace

void ProblemBuilder::overload() {
  const Table<ChannelId, bool> events = event_channels(problem_);
  Table<ChannelId, Taker> takers(problem_.channels.size());
  for (const Thread& thread : problem_.threads) {
    for (const StepId s : steps_of(problem_, thread)) {
      const Step& step = problem_.steps[s];
      for (std::size_t i = 0; step.kind == Step::Kind::wait && i < step.channels.size(); ++i) {
        const ChannelId channel = step.channels[i];
        if (!events[channel]) continue;
        Taker& taker = takers[channel];
        taker.alone = taker.alone && (taker.thread == nullptr || taker.thread == &thread);
        taker.thread = &thread;
        const auto round = least_round(problem_, events, step, i);
        if (round && (!taker.round || *round < *taker.round)) taker.round = round;
      }
    }
  }
  Table<ProcessorId, WideShare> asked(problem_.processors.size());
  Table<ProcessorId, std::string> by(problem_.processors.size());
  for (const Device& device : problem_.devices) {
    const auto* event = std::get_if<pan::EventDevice>(&device.behaviour);
    if (event == nullptr || !device.event.valid()) continue;
    const Taker& taker = takers[device.event];
    // Which of several threads takes how many events is open.
    if (!taker.alone || !taker.round || *taker.round == 0) continue;
    const WideShare part =
        std::min(static_cast<WideShare>(*taker.round) * whole_time / event->period.count(), most_asked);
    const ProcessorId processor = taker.thread->processor;
    asked[processor] += part;
    by[processor] += (by[processor].empty() ? "" : ", ") + taker.thread->name + " " + percent(part) +
                     " for " + problem_.channels[device.event].message;
  }
  for (const ProcessorId p : asked.ids()) {
    if (asked[p] <= whole_time) continue;
    problem_.overloaded.push_back(p);
    const pan::Processor& processor = problem_.processors[p];
    diagnostics_.report(Finding::more_work_than_time, processor.where, processor.name, percent(asked[p]),
                        by[p]);
  }
}

}  // namespace pal::analyzer
