#include "analyzer/whatif/short_enough.hpp"

#include <algorithm>
#include <optional>

#include "analyzer/problem/budgets.hpp"
#include "analyzer/whatif/requirement_checker.hpp"
#include "analyzer/whatif/trial.hpp"

namespace pal::analyzer::whatif {
namespace {

using Is = Verdict::State;

/// The time between two that are tried: three digits of the time as it is.
Nanoseconds grid_of(Nanoseconds worst) {
  Nanoseconds grid = 1;
  while (worst / grid >= 1000) grid *= 10;
  return grid;
}

class ShortEnoughSearch {
 public:
  ShortEnoughSearch(const pan::Network& network, const pan::Environment& environment,
                    const std::vector<Verdict>& before, const Options& options)
      : environment_(environment), before_(before), options_(options), checker_(network, options) {}

  /// For this requirement to hold, and all that holds as things are.
  std::optional<ShortEnough> search(RequirementId requirement, const Figure& figure) {
    asked_ = {requirement};
    for (std::size_t r = 0; r < before_.size(); ++r) {
      if (before_[r].state == Is::holds) asked_.emplace_back(r);
    }
    const Interval time = figure.time;
    if (time.worst.count() == 0) return std::nullopt;
    for (const Interval shortest : {Interval{time.best, time.best}, Interval{Duration(0), Duration(0)}}) {
      if (shortest.worst == time.worst || !holds(figure.name, shortest)) continue;
      const Interval enough = longest(figure, shortest);
      if (confirmed(figure.name, enough)) return ShortEnough{requirement, figure.name, time, enough};
    }
    return std::nullopt;
  }

 private:
  /// The longest that holds, from `shortest` on, which does.
  Interval longest(const Figure& figure, const Interval& shortest) {
    const Nanoseconds grid = grid_of(figure.time.worst.count());
    Interval good = shortest;
    Nanoseconds low = shortest.worst.count() / grid;
    Nanoseconds high = (figure.time.worst.count() + grid - 1) / grid;
    while (high - low > 1) {
      const Nanoseconds half = low + (high - low) / 2;
      const Interval tried{shortest.best, Duration(half * grid)};
      const bool does = holds(figure.name, tried);
      if (does) good = tried;
      (does ? low : high) = half;
    }
    return good;
  }

  std::optional<Problem> problem_with(const std::string& figure, const Interval& time) const {
    pan::Environment changed = environment_;
    *find_figure(changed, figure) = time;
    return checker_.problem(changed);
  }

  bool holds(const std::string& figure, const Interval& time) {
    const auto problem = problem_with(figure, time);
    if (!problem) return false;
    const Options trial = within(options_, budget::seconds_of_trial);
    const std::size_t classes = std::min(budget::classes_of_trial, trial.max_states);
    return checker_.ask(*problem, asked_, {classes, trial.stop}).state == Is::holds;
  }

  bool confirmed(const std::string& figure, const Interval& time) const {
    const auto problem = problem_with(figure, time);
    if (!problem || problem->requirements.size() != before_.size()) return false;
    const auto after = verdicts_on(*problem, options_, options_.max_states, budget::seconds_of_verdicts);
    return std::all_of(asked_.begin(), asked_.end(),
                       [&after](RequirementId r) { return after[r.index()].state == Is::holds; });
  }

  const pan::Environment& environment_;
  const std::vector<Verdict>& before_;
  const Options& options_;
  RequirementChecker checker_;
  RequirementIds asked_;
};

}  // namespace

std::vector<ShortEnough> short_enough_times(const pan::Network& network, const pan::Environment& environment,
                                            const std::vector<Verdict>& before, const Options& options) {
  ShortEnoughSearch search(network, environment, before, options);
  std::vector<ShortEnough> found;
  for (std::size_t r = 0; r < before.size(); ++r) {
    if (before[r].state == Is::holds || before[r].state == Is::never) continue;
    for (const Figure& figure : figures(network, environment)) {
      if (options.stop && options.stop()) return found;
      if (auto enough = search.search(RequirementId(r), figure)) found.push_back(std::move(*enough));
    }
  }
  return found;
}

}  // namespace pal::analyzer::whatif
