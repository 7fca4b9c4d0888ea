// Bounds of what requirements measure, from the times of segments.
#pragma once

#include <string>

#include "analyzer/compositional/times.hpp"

namespace pal::analyzer::compositional {

/// No run exceeds `value`; `never`: nothing is known, for the reason that `why` gives.
struct Bound {
  Nanoseconds value = never;
  std::string why;
};

struct View {
  const Problem& problem;
  const Forest& forest;
  const Conduct& conduct;
  const Times& times;
  /// By thread: it comes home from every round, whatever the run, as long as the skill lasts and it is not
  /// cancelled.
  const std::vector<bool>& reliable;
};

Bound response_bound(const View& view, const Requirement& requirement);
/// Number of events lost.
Bound loss_bound(const View& view, const Requirement& requirement);
Bound age_bound(const View& view, const Requirement& requirement);
/// Nanoseconds of work in a second; of the processor that has most.
Bound load_bound(const View& view, const Requirement& requirement);
Bound busy_bound(const View& view, const Requirement& requirement);

/// What View::reliable holds.
std::vector<bool> reliable_threads(const Problem& problem, const Forest& forest, const Conduct& conduct,
                                   const Times& times);

}  // namespace pal::analyzer::compositional
