#include "programs/pal/session/survey.hpp"

#include <algorithm>

#include "pal/trace/slices.hpp"

namespace pal::program {
namespace {

using analyzer::Nanoseconds;
using analyzer::Requirement;
using analyzer::run_checker::Measured;

constexpr double second = 1e9;

/// Whether `value` says more of the requirement than what was seen so far.
bool further(const Requirement& requirement, Nanoseconds value, const std::optional<Measured>& extreme) {
  return !extreme || requirement.allowed().worse(value, extreme->value);
}

/// The same of a value that may be `open`: one that breaks the requirement says more than any that may.
bool further(const Requirement& requirement, Nanoseconds value, bool open, const Seen& seen) {
  const bool breaks = !open && requirement.allowed().broken_by(value);
  const bool broken =
      !seen.extreme_is_open && seen.extreme && requirement.allowed().broken_by(seen.extreme->value);
  return breaks == broken ? further(requirement, value, seen.extreme) : breaks;
}

/// Whether a value that grows at the end of `run` counts, however the run goes on. It counts if it is
/// measured when the skill ends, or grows for ever. Where time stands still it does not.
bool counts(const Requirement& requirement, const KnownRun& run) {
  return run.still || (requirement.measure == Requirement::Measure::busy && !run.stands);
}

Nanoseconds busy_time(const std::vector<trace::Slice>& slices, const trace::Trace& run,
                      const std::string& processor) {
  Nanoseconds sum = 0;
  for (const trace::Slice& slice : slices) {
    if (slice.state != trace::State::running || slice.actor < 0) continue;
    if (run.actors[static_cast<std::size_t>(slice.actor)].processor == processor)
      sum += slice.to_ns - slice.from_ns;
  }
  return sum;
}

}  // namespace

Survey::Survey(const analyzer::Problem& problem) : problem_(problem), seen_(problem.requirements.size()) {}

bool Survey::add(const KnownRun& run, std::size_t number, const std::function<bool()>& stop) {
  const auto ruling = analyzer::run_checker::check_run(problem_, nullptr, run.trace,
                                                       run.completed ? std::nullopt : std::optional(run.end),
                                                       analyzer::run_checker::BusyFrom::each_pause, stop);
  if (ruling.stopped) return false;
  if (!ruling.broken.empty()) {
    refused_.push_back("run " + std::to_string(number) + ": " + ruling.broken);
    completed_ += run.completed ? 1 : 0;
    return true;
  }
  const std::vector<Seen> before = seen_;
  for (std::size_t r = 0; r < seen_.size(); ++r) {
    if (problem_.requirements[r].measure == Requirement::Measure::load) {
      measure_load(r, run, number);
    } else if (!measure(r, run, number, stop)) {
      seen_ = before;
      return false;
    }
  }
  completed_ += run.completed ? 1 : 0;
  return true;
}

bool Survey::measure(std::size_t index, const KnownRun& run, std::size_t number,
                     const std::function<bool()>& stop) {
  const Requirement& requirement = problem_.requirements[index];
  Seen& seen = seen_[index];
  const auto ruling = analyzer::run_checker::check_run(problem_, &requirement, run.trace, std::nullopt,
                                                       analyzer::run_checker::BusyFrom::beginning, stop);
  if (ruling.stopped) return false;
  bool breaks = ruling.failed;
  bool open = false;
  const auto note = [&](const Measured& measured, bool grows) {
    const bool may = grows && !counts(requirement, run);
    if (requirement.allowed().broken_by(measured.value)) (may ? open : breaks) = true;
    if (!further(requirement, measured.value, may, seen)) return;
    seen.extreme = measured;
    seen.grows = grows;
    seen.extreme_is_open = may;
    seen.run = number;
  };
  for (const Measured& measured : ruling.measured) note(measured, false);
  if (ruling.growing_since) note({run.end - *ruling.growing_since, *ruling.growing_since, run.end, {}}, true);
  seen.values += ruling.measured.size();
  seen.unanswered += ruling.failed ? 1 : 0;
  seen.breaking += breaks ? 1 : 0;
  seen.open += open && !breaks ? 1 : 0;
  return true;
}

void Survey::measure_load(std::size_t index, const KnownRun& run, std::size_t number) {
  if (run.end == 0) return;
  Seen& seen = seen_[index];
  const auto slices = trace::slices(run.trace, run.end);
  for (const analyzer::ProcessorId processor : problem_.requirements[index].processors) {
    const Nanoseconds busy = busy_time(slices, run.trace, problem_.processors[processor].name);
    const auto share =
        static_cast<Nanoseconds>(second * static_cast<double>(busy) / static_cast<double>(run.end));
    ++seen.values;
    if (!further(problem_.requirements[index], share, seen.extreme)) continue;
    seen.extreme = Measured{share, 0, run.end, {}};
    seen.run = number;
  }
}

std::optional<std::size_t> most_interesting(const analyzer::Problem& problem, const std::vector<Seen>& seen) {
  std::optional<std::size_t> best;
  double best_share = -1;
  for (std::size_t r = 0; r < seen.size(); ++r) {
    const Requirement& requirement = problem.requirements[r];
    if (!seen[r].extreme || requirement.measure == Requirement::Measure::load) continue;
    if (seen[r].breaking > 0) return r;
    if (requirement.limit == 0 || requirement.at_least) continue;
    const double share = static_cast<double>(seen[r].extreme->value) / static_cast<double>(requirement.limit);
    if (share <= best_share) continue;
    best = r;
    best_share = share;
  }
  return best;
}

}  // namespace pal::program
