// The search for the slack of one figure, or of several that grow in proportion: by bounds alone, then by a
// bracket for requirements and one for loads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyzer/whatif/bracket.hpp"
#include "analyzer/whatif/slack.hpp"

namespace pal::analyzer::whatif {

/// Works in turns. Each turn goes on where the last one ended.
class FigureSearch {
 public:
  FigureSearch(const pan::Environment& environment, std::vector<std::string> names, const Problem& problem);
  FigureSearch(const FigureSearch&) = delete;
  FigureSearch& operator=(const FigureSearch&) = delete;

  /// Looks for the greatest growth that bounds alone show to hold.
  void bound(RequirementChecker& checker, const RequirementIds& all, const Effort& effort);

  /// Loads have half of the time, and what the others leave; these have what loads leave.
  void narrow(RequirementChecker& checker, const Effort& half, const Effort& whole, Precision precision);

  bool exact() const;
  /// What this round could decide is decided.
  bool exhausted() const;

  /// Writes what is known to `slack`.
  void tell(Slack& slack) const;

 private:
  Nanoseconds ceiling_of(const Bracket& bracket) const;
  Nanoseconds holds() const;
  std::optional<Nanoseconds> fails() const;

  const Scaling scaling_;
  Bracket timed_;
  Bracket loads_;
  Nanoseconds bounded_ = 0;  // holds by bounds alone
  Nanoseconds unbounded_;    // does not; beyond the greatest growth: not looked for
  Nanoseconds step_;
};

}  // namespace pal::analyzer::whatif
