// Holistic analysis, from the book: the baseline that compositional bounds must not exceed.
//
// K. Tindell, J. Clark, Holistic schedulability analysis for distributed hard real-time systems, 1994. The
// jitter of a stage is the variation of its predecessor's response time. Nothing is known of offsets. Shares
// no code with the analyzer.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "tests/support/chain_system.hpp"

namespace pal::test {

/// By chain: the worst response from its event to the end of its last stage; nothing if it does not converge.
inline std::vector<std::optional<analyzer::Nanoseconds>> holistic(const ChainSystem& system) {
  using Time = analyzer::Nanoseconds;
  struct Task {
    std::size_t chain;
    std::size_t stage;
    analyzer::ProcessorId processor;
    int priority;
    Time period;
    Time cost;
    Time jitter;
    Time best;   // least time from the event to its release
    Time worst;  // and the greatest to its end
  };
  constexpr Time longest = 100'000'000'000;
  std::vector<Task> tasks;
  for (std::size_t c = 0; c < system.chains.size(); ++c) {
    Time best = 0;
    for (std::size_t s = 0; s < system.chains[c].stages.size(); ++s) {
      const ChainSystem::Stage& stage = system.chains[c].stages[s];
      const bool far = s > 0 && system.chains[c].stages[s - 1].processor != stage.processor;
      if (far) best += system.latency.best;
      tasks.push_back({c, s, stage.processor, stage.priority, system.chains[c].period, stage.worst,
                       s == 0 ? system.chains[c].jitter : 0, best, 0});
      best += stage.best;
    }
  }
  bool diverged = false;
  const auto response = [&](const Task& task) -> Time {
    const bool preemptive = system.preemptive[task.processor.index()];
    Time blocking = 0;
    for (const Task& other : tasks) {
      if (!preemptive && other.processor == task.processor && other.priority < task.priority) {
        blocking = std::max(blocking, other.cost);
      }
    }
    Time worst = 0;
    Time window = 0;
    for (Time q = 0;; ++q) {
      const Time own = preemptive ? (q + 1) * task.cost : q * task.cost;
      window = std::max(window, blocking + own);
      for (;;) {
        Time next = blocking + own;
        for (const Task& other : tasks) {
          if (&other == &task || other.processor != task.processor || other.priority <= task.priority)
            continue;
          const Time counted = other.jitter + window;
          const Time jobs =
              preemptive ? (counted + other.period - 1) / other.period : counted / other.period + 1;
          next += jobs * other.cost;
        }
        if (next <= window) break;
        if (next > longest) {
          diverged = true;
          return longest;
        }
        window = next;
      }
      const Time done = preemptive ? window : window + task.cost;
      worst = std::max(worst, done - q * task.period + task.jitter);
      Time drained = done;  // when all that came meanwhile is done, too
      for (bool more = !preemptive; more;) {
        Time next = blocking + (q + 1) * task.cost;
        for (const Task& other : tasks) {
          if (&other == &task || other.processor != task.processor || other.priority <= task.priority)
            continue;
          next += (other.jitter + drained + other.period - 1) / other.period * other.cost;
        }
        more = next > drained && next <= longest;
        drained = std::max(drained, next);
      }
      if (drained + task.jitter <= (q + 1) * task.period) break;
    }
    return worst;
  };
  for (bool changed = true; changed && !diverged;) {
    changed = false;
    for (std::size_t t = 0; t < tasks.size() && !diverged; ++t) {
      Task& task = tasks[t];
      if (task.stage > 0) {
        const Task& before = tasks[t - 1];
        const bool far = before.processor != task.processor;
        const Time release = before.worst + (far ? system.latency.worst : 0);
        task.jitter = std::max(task.jitter, release - task.best);
      }
      // Responses count from the nominal event; a stage's own window from its earliest release.
      const Time worst = task.best + response(task);
      if (worst > task.worst) {
        task.worst = worst;
        changed = true;
      }
    }
  }
  std::vector<std::optional<Time>> bounds(system.chains.size());
  for (const Task& task : tasks) {
    if (!diverged && task.stage + 1 == system.chains[task.chain].stages.size())
      bounds[task.chain] = task.worst;
  }
  return bounds;
}

}  // namespace pal::test
