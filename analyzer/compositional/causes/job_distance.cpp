#include "analyzer/compositional/causes/job_distance.hpp"

#include <algorithm>
#include <queue>

#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {

using Kind = Step::Kind;

StepId fork_of(const Problem& problem, ThreadId block) {
  for (const StepId s : problem.steps.ids()) {
    const auto& blocks = problem.steps[s].threads;
    if (std::find(blocks.begin(), blocks.end(), block) != blocks.end()) return s;
  }
  return StepId{};
}

namespace {

bool may_start_again(const Problem& problem, ThreadId thread) {
  // A block is started by a fork; that comes again if the flow can come back to it, or its thread may start
  // again.
  const ThreadId parent = problem.threads[thread].parent;
  if (!parent.valid()) return false;
  for (const StepId s : problem.steps.ids()) {
    const Step& fork = problem.steps[s];
    if (std::find(fork.threads.begin(), fork.threads.end(), thread) == fork.threads.end()) continue;
    if (comes_back(problem, s)) return true;
  }
  return may_start_again(problem, parent);
}

}  // namespace

bool recurrent(const Problem& problem, const Beginning& beginning) {
  if (may_start_again(problem, beginning.thread)) return true;
  return beginning.kind != Beginning::Kind::entry && comes_back(problem, beginning.step);
}

bool ends_straight(const Problem& problem, ThreadId block) {
  std::map<StepId, int> mark;  // 1: open, 2: done
  std::vector<std::pair<StepId, std::size_t>> way{{problem.threads[block].entry, 0}};
  while (!way.empty()) {
    auto& [at, place] = way.back();
    const Step& step = problem.steps[at];
    if (place == 0) {
      mark[at] = 1;
      for (ThreadId inner : step.threads) {
        if (problem.threads[inner].can_end && !ends_straight(problem, inner)) return false;
      }
    }
    if (place == step.next.size()) {
      mark[at] = 2;
      way.pop_back();
      continue;
    }
    const StepId next = step.next[place++];
    const int known = mark.contains(next) ? mark[next] : 0;
    if (known == 1) return false;
    if (known == 0) way.emplace_back(next, 0);
  }
  return true;
}

namespace {

/// However long a way is, it leads somewhere.
Nanoseconds later_by(Nanoseconds time, Nanoseconds by) {
  return std::min(plus(time, by), never - 1);
}

/// Shortest ways through threads, with the least that each action, limit and answer takes.
class Shortest {
 public:
  explicit Shortest(const Problem& problem) : problem_(problem) {}

  /// From `first` at time `at` until `ends` holds of a step that is reached.
  template <class Ends>
  Nanoseconds way(StepId first, Nanoseconds at, int depth, const Ends& ends) {
    std::map<StepId, Nanoseconds> reached;
    std::map<ChannelId, Nanoseconds> sent;  // by request: least time of its send
    using Entry = std::pair<Nanoseconds, StepId>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    open.emplace(at, first);
    while (!open.empty()) {
      const auto [time, index] = open.top();
      open.pop();
      if (ends(index)) return time;
      if (!reached.emplace(index, time).second) continue;
      const Step& step = problem_.steps[index];
      if (step.kind == Kind::send) sent.emplace(step.channels.front(), later_by(time, step.cost.best));
      for (std::size_t i = 0; i < step.next.size(); ++i) {
        Nanoseconds after = later_by(time, step.cost.best);
        if (step.kind == Kind::wait && i == step.channels.size()) {
          after = later_by(later_by(time, step.within.value_or(0)), step.give_up_cost.best);
        } else if (step.kind == Kind::wait) {
          const ChannelId request = problem_.channels[step.channels[i]].answers;
          const bool asked =
              request.valid() && sent.contains(request) && !reaches_unasked(first, index, request);
          if (asked)
            after = later_by(std::max(time, later_by(sent[request], answer(step.channels[i], depth))),
                             step.cost.best);
        }
        open.emplace(after, step.next[i]);
      }
    }
    return never;
  }

  /// Least time from a request's send to its answer.
  Nanoseconds answer(ChannelId channel, int depth) {
    const Channel& of = problem_.channels[channel];
    if (!of.answers.valid()) return 0;
    if (of.sender_device.valid()) {
      const auto& behaviour = problem_.devices[of.sender_device].behaviour;
      if (const auto* request = std::get_if<pan::RequestDevice>(&behaviour))
        return request->answer.best.count();
      if (const auto* frames = std::get_if<pan::FrameDevice>(&behaviour)) return frames->collecting.count();
      return 0;
    }
    if (depth > 8) return 0;
    Nanoseconds least = never;
    for (const Step& take : problem_.steps) {
      if (take.kind != Kind::wait) continue;
      for (std::size_t arm = 0; arm < take.channels.size(); ++arm) {
        if (take.channels[arm] != of.answers) continue;
        const auto sends = [&](StepId index) {
          const Step& step = problem_.steps[index];
          return step.kind == Kind::send && step.channels.front() == channel;
        };
        least = std::min(least, way(take.next[arm], take.cost.best, depth + 1, sends));
      }
    }
    return least >= never ? 0 : least;
  }

  /// Whether a wait can be reached without the request that it waits for having been sent on the way.
  bool reaches_unasked(StepId first, StepId wait, ChannelId request) const {
    return follow(problem_, {first}, [&](StepId at) {
      if (at == wait) return Course::found;
      const Step& step = problem_.steps[at];
      return step.kind == Kind::send && step.channels.front() == request ? Course::ends : Course::goes_on;
    });
  }

 private:
  const Problem& problem_;
};

}  // namespace

Nanoseconds least_job_distance(const Problem& problem, const Beginning& beginning) {
  if (may_start_again(problem, beginning.thread)) return 0;
  const bool gives_up = beginning.kind == Beginning::Kind::give_up;
  if (beginning.kind != Beginning::Kind::arm && !gives_up) return 0;
  const Step& idle_wait = problem.steps[beginning.step];
  const std::size_t branch = gives_up ? idle_wait.channels.size() : static_cast<std::size_t>(beginning.arm);
  // A job begins when the wait ends: with its receive, or with the test that gives up.
  const Nanoseconds into = gives_up ? idle_wait.give_up_cost.best : idle_wait.cost.best;
  Shortest shortest(problem);
  const Nanoseconds around =
      shortest.way(idle_wait.next[branch], into, 0, [&](StepId step) { return step == beginning.step; });
  if (around >= never) return never;
  if (gives_up) return later_by(around, idle_wait.within.value_or(0));
  const ChannelId answer = idle_wait.channels[branch];
  const ChannelId request = problem.channels[answer].answers;
  if (!request.valid()) return around;
  // A block of the thread may ask, too, sooner.
  if (shortest.reaches_unasked(idle_wait.next[branch], beginning.step, request)) return around;
  const Nanoseconds asked = shortest.way(idle_wait.next[branch], into, 0, [&](StepId index) {
    const Step& step = problem.steps[index];
    return step.kind == Kind::send && step.channels.front() == request;
  });
  return asked >= never ? around : std::max(around, later_by(asked, shortest.answer(answer, 0)));
}

namespace {

/// Longest work of a thread from a step to its idle wait; `never`: it may wait on the way, or loop elsewhere.
class Straight {
 public:
  Straight(const Problem& problem, StepId idle_wait) : problem_(problem), idle_wait_(idle_wait) {}

  Nanoseconds idle_from(StepId step) {
    const auto leads_on = [this](StepId at) {
      return at != idle_wait_ && !stops(at) && !known_.contains(at);
    };
    backwards(problem_, step, leads_on, [this](StepId at) { known_.emplace(at, from(at)); });
    return known_.at(step);
  }

 private:
  bool stops(StepId step) const {
    const Kind kind = problem_.steps[step].kind;
    return kind == Kind::wait || kind == Kind::fork;
  }

  /// From one step, by the results of those that follow; unbounded in a loop.
  Nanoseconds from(StepId step) const {
    if (step == idle_wait_) return 0;
    if (stops(step)) return never;
    const Step& of = problem_.steps[step];
    Nanoseconds longest = 0;
    for (StepId next : of.next) {
      const auto after = known_.find(next);
      longest = std::max(longest, after == known_.end() ? never : after->second);
    }
    return plus(longest, of.cost.worst);
  }

  const Problem& problem_;
  StepId idle_wait_;
  std::map<StepId, Nanoseconds> known_;
};

}  // namespace

bool waits_between_jobs(const Problem& problem, const Beginning& job, const Table<StepId, bool>& owned) {
  const Step& idle_wait = problem.steps[job.step];
  if (job.kind == Beginning::Kind::give_up) return idle_wait.within.value_or(0) > 0;
  if (job.kind != Beginning::Kind::arm) return false;
  const ChannelId answer = idle_wait.channels[static_cast<std::size_t>(job.arm)];
  const ChannelId request = problem.channels[answer].answers;
  if (!request.valid()) return false;
  const Nanoseconds soonest = Shortest(problem).answer(answer, 0);
  Straight straight(problem, job.step);
  for (const StepId s : problem.steps.ids()) {
    const Step& step = problem.steps[s];
    if (!owned[s] || step.kind != Kind::send || step.channels.front() != request) continue;
    if (straight.idle_from(step.next.front()) >= soonest) return false;
  }
  return true;
}

Nanoseconds least_effect_distance(const Problem& problem, ThreadId thread, const Table<StepId, bool>& at) {
  if (may_start_again(problem, thread)) return 0;
  Shortest shortest(problem);
  std::set<StepId> seen;
  std::vector<StepId> open{problem.threads[thread].entry};
  Nanoseconds least = never;
  while (!open.empty()) {
    const StepId from = open.back();
    open.pop_back();
    if (!seen.insert(from).second) continue;
    const Step& step = problem.steps[from];
    open.insert(open.end(), step.next.begin(), step.next.end());
    if (!at[from]) continue;
    for (StepId next : step.next) {
      const auto passed = [&](StepId index) { return at[index]; };
      least = std::min(least, shortest.way(next, 0, 0, passed));
    }
  }
  Nanoseconds itself = never;  // of the one that comes next
  for (const StepId s : at.ids()) {
    if (!at[s]) continue;
    const Step& step = problem.steps[s];
    itself =
        std::min(itself, step.within ? std::min(step.cost.best, step.give_up_cost.best) : step.cost.best);
  }
  return least >= never ? never : later_by(least, itself);
}

}  // namespace pal::analyzer::compositional
