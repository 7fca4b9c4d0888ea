// The two analyses as one: exact where that can be had, compositional where not.
#pragma once

#include <functional>

#include "analyzer/exact/exact.hpp"

namespace pal::analyzer {

enum class AnalysisChoice {
  /// What is cheap first, until each requirement is decided: bounds, a few thousand classes, single runs,
  /// slices, all runs.
  automatic,
  thorough,      // the same, and on till each bound is known to be attained
  exact,         // exact alone
  compositional  // compositional alone
};

/// Each verdict says which analysis it is from. A run that the exact analysis found is kept, whatever the
/// bound.
Analysis analyze(const Problem& problem, AnalysisChoice choice, const Options& options = {});

/// The two, each by itself.
struct Provers {
  std::function<Analysis(const Problem&, const Options&)> exact;
  std::function<Analysis(const Problem&, const Options&)> compositional;
};

/// The same with others in their places: for tests of what becomes of proofs that are wrong.
Analysis analyze_with(const Provers& provers, const Problem& problem, AnalysisChoice choice,
                      const Options& options = {});

}  // namespace pal::analyzer
