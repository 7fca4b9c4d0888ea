// Both analyses together: exact where possible, compositional elsewhere.
#pragma once

#include <functional>
#include <string>

#include "analyzer/exact/exact.hpp"

namespace pal::analyzer {

enum class AnalysisChoice {
  /// The cheapest first, until each requirement is decided: bounds, a few thousand classes, single runs,
  /// slices, all runs.
  automatic,
  thorough,       // the same, and on till each bound is known to be attained
  exact,          // exact alone
  compositional,  // compositional alone
  /// The same with half-open windows, as textbooks have them: a job that is released at the instant at which
  /// another ends does not delay it. Runs of PAL may exceed such a bound, so none is compared with it.
  half_open
};

/// Each verdict says which analysis it comes from. A run that the exact analysis found is kept, whatever the
/// bound.
Analysis analyze(const Problem& problem, AnalysisChoice choice, const Options& options = {});

/// Each requirement undecided, for the reason `why`: of what has not been looked at.
Analysis nothing_known(const Problem& problem, const std::string& why);

/// The two, each by itself.
struct Provers {
  std::function<Analysis(const Problem&, const Options&)> exact;
  std::function<Analysis(const Problem&, const Options&)> compositional;
};

/// The same with other analyses: for tests that give wrong proofs on purpose.
Analysis analyze_with(const Provers& provers, const Problem& problem, AnalysisChoice choice,
                      const Options& options = {});

}  // namespace pal::analyzer
