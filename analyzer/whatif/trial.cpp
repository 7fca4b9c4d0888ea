#include "analyzer/whatif/trial.hpp"

#include <algorithm>
#include <cassert>

namespace pal::analyzer::whatif {
namespace {

using Is = Verdict::State;

/// What is without bound is so far from its limit: in limits.
constexpr double far_off = 10;

double missed_by(const Verdict& verdict) {
  if (verdict.state == Is::holds) return 0;
  const auto value = verdict.state == Is::fails ? attained(verdict) : verdict.bound;
  if (!value) return far_off;
  const double limit = std::max<double>(1, static_cast<double>(verdict.limit.count()));
  const auto over = -static_cast<double>(verdict.allowed().margin(value->count()));
  return std::clamp(over / limit, 0.001, far_off);
}

}  // namespace

Options within(const Options& given, double seconds) {
  Options options = given;
  options.addends = false;
  if (!given.clock) return options;
  double end = given.clock() + seconds;
  if (given.deadline) end = std::min(end, *given.deadline);
  options.deadline = end;
  options.stop = [stop = given.stop, clock = given.clock, end] { return (stop && stop()) || clock() > end; };
  return options;
}

std::vector<Verdict> verdicts_on(const Problem& problem, const Options& options, std::size_t classes,
                                 double seconds) {
  Options limited = within(options, seconds);
  limited.max_states = std::min(classes, options.max_states);
  return analyze(problem, AnalysisChoice::automatic, limited).verdicts;
}

double missed(const std::vector<Verdict>& after, const std::vector<Verdict>& before) {
  assert(after.size() == before.size());
  double sum = 0;
  for (std::size_t r = 0; r < after.size(); ++r) {
    const bool vacuous = after[r].state == Is::never && before[r].state == Is::never;
    if (!vacuous) sum += missed_by(after[r]);
  }
  return sum;
}

}  // namespace pal::analyzer::whatif
