// Processors that have more to do for the events of the world than there is time.
#include <algorithm>
#include <functional>
#include <queue>

#include "analyzer/problem_builder.hpp"
#include "pal/support/diagnostic_code.hpp"

namespace pal::analyzer {
namespace {

__extension__ using Wide = __int128;
constexpr Wide most_asked = 1'000'000'000;  // millionths: a thousand times the time that there is

/// The least processor time, if each action takes its worst, from taking a message at `wait` until it is
/// waited for again; nothing if the thread does not come back. E. W. Dijkstra, A note on two problems in
/// connexion with graphs, 1959.
std::optional<Nanoseconds> least_round(const Problem& problem, int wait, std::size_t branch) {
  using Reached = std::pair<Nanoseconds, int>;
  const Step& first = problem.steps[static_cast<std::size_t>(wait)];
  std::vector<bool> done(problem.steps.size());
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  open.push({first.cost.worst, first.next[branch]});
  while (!open.empty()) {
    const auto [work, at] = open.top();
    open.pop();
    if (at == wait) return work;
    if (done[static_cast<std::size_t>(at)]) continue;
    done[static_cast<std::size_t>(at)] = true;
    const Step& step = problem.steps[static_cast<std::size_t>(at)];
    for (const int next : step.next) open.push({work + step.cost.worst, next});
  }
  return std::nullopt;
}

std::string percent(Nanoseconds millionths) {
  return std::to_string(millionths / 10'000) + "." + std::to_string(millionths / 1'000 % 10) + " %";
}

}  // namespace

void ProblemBuilder::overload() {
  std::vector<Nanoseconds> asked(problem_.processors.size());  // millionths of the time
  std::vector<std::string> by(problem_.processors.size());
  for (const Device& device : problem_.devices) {
    const auto* event = std::get_if<pan::EventDevice>(&device.behaviour);
    if (event == nullptr || device.event < 0) continue;
    for (const Thread& thread : problem_.threads) {
      std::optional<Nanoseconds> least;
      for (const std::size_t s : steps_of(thread)) {
        const Step& step = problem_.steps[s];
        for (std::size_t i = 0; step.kind == Step::Kind::wait && i < step.channels.size(); ++i) {
          if (step.channels[i] != device.event) continue;
          const auto round = least_round(problem_, static_cast<int>(s), i);
          if (round && (!least || *round < *least)) least = round;
        }
      }
      if (!least || *least == 0) continue;
      const Wide share = static_cast<Wide>(*least) * 1'000'000 / event->period.count();
      const auto part = static_cast<Nanoseconds>(std::min(share, most_asked));
      const auto processor = static_cast<std::size_t>(thread.processor);
      asked[processor] += part;
      by[processor] += (by[processor].empty() ? "" : ", ") + thread.name + " " + percent(part) + " for " +
                       problem_.channels[static_cast<std::size_t>(device.event)].message;
    }
  }
  for (std::size_t p = 0; p < asked.size(); ++p) {
    if (asked[p] <= 1'000'000) continue;
    const pan::Processor& processor = problem_.processors[p];
    diagnostics_.report(
        Code::PAL0820, processor.where,
        "processor " + processor.name + " has more to do than time when events come as often as they may: " +
            percent(asked[p]) + " (" + by[p] + ")",
        "move one of them to another processor, shorten its work, or let its events come less often");
  }
}

}  // namespace pal::analyzer
