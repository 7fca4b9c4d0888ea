#include "analyzer/watch.hpp"

namespace pal::analyzer {
namespace {

bool mentions(const pan::Guard& guard, int condition) {
  if (guard.kind == pan::Guard::Kind::equals) return guard.condition.value == condition;
  for (const pan::Guard& term : guard.terms) {
    if (mentions(term, condition)) return true;
  }
  return false;
}

/// Whether `known` holds of any step that may come after `step`, in its thread or in the blocks that it
/// starts.
bool any_after(const Problem& problem, const Step& step, const std::vector<bool>& known) {
  for (int next : step.next) {
    if (known[static_cast<std::size_t>(next)]) return true;
  }
  for (int thread : step.threads) {
    if (known[static_cast<std::size_t>(problem.threads[static_cast<std::size_t>(thread)].entry)]) return true;
  }
  return false;
}

}  // namespace

bool tests(const Step& step, int condition) {
  if (step.kind != Step::Kind::test) return false;
  for (const pan::Guard& guard : step.guards) {
    if (mentions(guard, condition)) return true;
  }
  return false;
}

Watch watch_of(const Problem& problem, const Requirement& requirement) {
  Watch watch;
  if (requirement.measure == Requirement::Measure::load) return watch;
  watch.at = requirement.at;
  watch.counts.assign(problem.steps.size(), false);
  watch.read_ahead.assign(problem.steps.size(), false);
  if (requirement.measure == Requirement::Measure::response) {
    watch.kind = Watch::Kind::response;
    watch.event = requirement.event;
    return watch;
  }
  watch.kind = Watch::Kind::age;
  watch.condition = requirement.condition;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t s = 0; s < problem.steps.size(); ++s) {
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
  return watch;
}

}  // namespace pal::analyzer
