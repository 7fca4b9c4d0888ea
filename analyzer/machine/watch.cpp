#include "analyzer/machine/watch.hpp"

#include <algorithm>

#include "analyzer/machine/loss_rows.hpp"

namespace pal::analyzer {
namespace {

bool mentions(const pan::Guard& guard, ConditionId condition) {
  if (guard.kind == pan::Guard::Kind::equals) return guard.condition == condition;
  for (const pan::Guard& term : guard.terms) {
    if (mentions(term, condition)) return true;
  }
  return false;
}

/// Whether `known` holds of any step that may come after `step`, in its thread or in the blocks that it
/// starts.
bool any_after(const Problem& problem, const Step& step, const Table<StepId, bool>& known) {
  for (StepId next : step.next) {
    if (known[next]) return true;
  }
  for (ThreadId thread : step.threads) {
    if (known[problem.threads[thread].entry]) return true;
  }
  return false;
}

/// Steps from which one of `at` may come. Most steps stand behind those that lead to them: what is found goes
/// from the last to the first, here and below.
Table<StepId, bool> before(const Problem& problem, const Table<StepId, bool>& at) {
  Table<StepId, bool> found = at;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = problem.steps.size(); i-- > 0;) {
      const StepId s(i);
      if (found[s] || !any_after(problem, problem.steps[s], found)) continue;
      found[s] = changed = true;
    }
  }
  return found;
}

/// Steps that complete the skill with `code`.
Table<StepId, bool> completions(const Problem& problem, int code) {
  Table<StepId, bool> at(problem.steps.size());
  for (const StepId s : problem.steps.ids()) {
    const Step& step = problem.steps[s];
    at[s] = step.kind == Step::Kind::complete && step.code == code;
    const bool may_fail = step.kind == Step::Kind::test && step.next.size() == step.guards.size();
    at[s] = at[s] || (may_fail && code == problem.error_code);
  }
  return at;
}

/// A read gives the value that counts from then on, whatever the thread had read before.
void follow_reads(const Problem& problem, Watch& watch) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = problem.steps.size(); i-- > 0;) {
      const StepId s(i);
      const Step& step = problem.steps[s];
      const bool reads_always = step.kind == Step::Kind::read && step.condition == watch.condition;
      const bool used = watch.at[s] || any_after(problem, step, watch.counts);
      const bool counts = used && !reads_always;
      const bool reads = reads_always || tests(step, watch.condition);
      const bool ahead = (reads && used) || any_after(problem, step, watch.read_ahead);
      if (counts != watch.counts[s] || ahead != watch.read_ahead[s]) {
        watch.counts[s] = counts;
        watch.read_ahead[s] = ahead;
        changed = true;
      }
    }
  }
}

/// What a thread knows of a sample goes on with what it sends and sets.
class Samples {
 public:
  Samples(const Problem& problem, Watch& watch) : problem_(problem), watch_(watch) {
    for (const bool sample : watch.samples) sources_ += sample ? 1 : 0;
  }

  void follow() {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t s = problem_.steps.size(); s-- > 0;) changed = visit(StepId(s)) || changed;
    }
  }

 private:
  bool visit(StepId s) {
    const Step& step = problem_.steps[s];
    const bool after = any_after(problem_, step, watch_.counts);
    const bool used = watch_.at[s] || after;
    bool changed = false;
    if (step.kind == Step::Kind::wait) {
      for (const ChannelId channel : step.channels) {
        const KeptId kept = problem_.channels[channel].kept;
        const bool left = kept.valid() && watch_.kept_counts[kept];
        if (!used && !left) continue;
        if (watch_.message_counts[channel]) continue;
        watch_.message_counts[channel] = changed = true;
      }
    }
    for (std::size_t c = 0; c < problem_.conditions.size() && used; ++c) {
      const bool reads =
          (step.kind == Step::Kind::read && step.condition == ConditionId(c)) || tests(step, ConditionId(c));
      const std::uint64_t bit = std::uint64_t{1} << c;
      if (!reads || (watch_.condition_counts & bit) != 0) continue;
      watch_.condition_counts |= bit;
      changed = true;
    }
    // What is used counts where the thread knows it, at this step and behind it.
    for (const KeptId kept : step.uses) {
      if ((!used && !passes_on(step)) || watch_.kept_counts[kept]) continue;
      watch_.kept_counts[kept] = changed = true;
    }
    const bool counts = (used && !renews(step)) || passes_on(step);
    if (counts == watch_.counts[s]) return changed;
    watch_.counts[s] = counts;
    return true;
  }

  /// The thread gets a newer sample here, whatever it had.
  bool renews(const Step& step) const {
    return step.kind == Step::Kind::wait && !step.within && step.channels.size() == 1 && sources_ == 1 &&
           watch_.samples[step.channels.front()];
  }

  bool passes_on(const Step& step) const {
    const bool writes = std::any_of(step.writes.begin(), step.writes.end(),
                                    [this](KeptId kept) { return watch_.kept_counts[kept]; });
    if (writes) return true;
    if (step.kind == Step::Kind::send) {
      return watch_.message_counts[step.channels.front()];
    }
    return step.kind == Step::Kind::set && (watch_.condition_counts >> step.condition.index() & 1U) != 0;
  }

  const Problem& problem_;
  Watch& watch_;
  int sources_ = 0;
};

}  // namespace

bool tests(const Step& step, ConditionId condition) {
  if (step.kind != Step::Kind::test) return false;
  for (const pan::Guard& guard : step.guards) {
    if (mentions(guard, condition)) return true;
  }
  return false;
}

Watch watch_of(const Problem& problem, const Requirement& requirement, ProcessorId processor) {
  using Measure = Requirement::Measure;
  Watch watch;
  watch.limit = requirement.limit;
  watch.at = requirement.at;
  watch.at.resize(problem.steps.size());
  watch.phase = requirement.phase;
  if (!watch.phase.after.empty()) watch.phase.after.resize(problem.steps.size());
  if (!watch.phase.during.empty()) watch.phase.during.resize(problem.steps.size());
  watch.counts.assign(problem.steps.size(), false);
  watch.read_ahead.assign(problem.steps.size(), false);
  switch (requirement.measure) {
    case Measure::load:
      return {};
    case Measure::response:
      watch.kind = Watch::Kind::response;
      watch.events.assign(problem.channels.size(), false);
      for (const ChannelId channel : requirement.events) watch.events[channel] = true;
      break;
    case Measure::age:
    case Measure::reaction:
      watch.reaction = requirement.measure == Measure::reaction;
      if (requirement.samples.empty()) {
        watch.kind = Watch::Kind::age;
        watch.condition = requirement.condition;
        follow_reads(problem, watch);
        break;
      }
      watch.kind = Watch::Kind::sample;
      watch.samples.assign(problem.channels.size(), false);
      watch.message_counts.assign(problem.channels.size(), false);
      watch.kept_counts.assign(problem.kept.size(), false);
      for (const ChannelId channel : requirement.samples) watch.samples[channel] = true;
      Samples(problem, watch).follow();
      break;
    case Measure::interval:
      watch.kind = Watch::Kind::interval;
      watch.least = requirement.at_least;
      break;
    case Measure::loss:
      watch.kind = Watch::Kind::loss;
      watch.device = requirement.device;
      watch.in = std::min(requirement.in, longest_followed_row);
      break;
    case Measure::duration:
      watch.kind = Watch::Kind::duration;
      watch.code = requirement.code;
      watch.at = completions(problem, requirement.code);
      break;
    case Measure::busy:
      watch.kind = Watch::Kind::busy;
      watch.processor = !processor.valid() ? requirement.processors.front() : processor;
      break;
  }
  watch.live = before(problem, watch.at);
  return watch;
}

}  // namespace pal::analyzer
