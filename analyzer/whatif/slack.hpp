// By how much worst times may grow before some requirement no longer holds.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/exact/exact.hpp"
#include "analyzer/whatif/figures.hpp"
#include "analyzer/whatif/ids.hpp"

namespace pal::analyzer::whatif {

/// Best times stay. So a grown time is an interval that holds the old one, and every old run is still a run.
/// What breaks a requirement goes on breaking it (docs/reference/what-if.md).
struct Slack {
  std::string figure;  // empty: all together
  Interval time;       // as it is; all together: the longest worst time
  /// The growth with which everything was proved to hold. Nothing: not even as it is.
  std::optional<Duration> holds;
  /// The growth with which something was proved to fail (0: as it is). Nothing: not found.
  std::optional<Duration> fails;
  /// Everything holds whatever the time, up to the longest that the model allows.
  bool unlimited = false;
  RequirementId requirement;  // that fails, or could not be decided
  bool ended = false;         // by the time, not because nothing more can be decided

  /// To the nanosecond.
  bool exact() const { return unlimited || (holds && fails && *fails - *holds == Duration(1)); }
};

/// To watch the search. Called by one thread at a time.
struct SlackObserver {
  /// Nothing more is looked for of this one: it is exact, or cannot be decided. Not called of those that the
  /// end of the time leaves open.
  std::function<void(const Slack&)> settled;
  /// After each question: how many of all are settled.
  std::function<void(std::size_t settled, std::size_t all)> asked;
};

/// Slack of each figure by itself, then of all together. All together grow in proportion. With `holds` = k
/// each worst time w becomes w + w · k / longest, rounded up, where `longest` is the longest of them. If that
/// is 0, all become k. If a requirement does not hold as things are, there is no slack. Then `requirement` is
/// the index of one such requirement, and `fails` is 0 if a run breaks it.
///
/// Works in rounds. The first round asks only what bounds and single runs decide. Each next round explores
/// more. With Options::clock it gives each open figure half a second, then three times as much. So all have a
/// first answer soon. Then up to four figures are looked at by as many of the threads at the same time.
std::vector<Slack> slacks(const pan::Network& network, const pan::Environment& environment,
                          const Options& options, const SlackObserver& observer = {});

}  // namespace pal::analyzer::whatif
