// What is looked at of all requirements first, in a moment.
#pragma once

#include <optional>
#include <vector>

#include "analyzer/analysis.hpp"

namespace pal::analyzer {

/// What a moment's exploration shows of every requirement.
Analysis look_at_all(const Provers& provers, const Problem& problem, const Options& options,
                     const std::vector<Verdict>& bounds);

/// A bound settles no load of the long run if there is none.
void say_ends(const Problem& problem, const Options& options, Analysis& analysis);

/// A long row of losses consists of short ones, which are explored much sooner. The verdict is what they
/// show: it holds, or is undecided with a bound. Nothing: they show nothing.
std::optional<Verdict> by_shorter_rows(const Provers& provers, const Problem& problem,
                                       const Requirement& requirement, const Options& options);

/// What is proved of a requirement holds for those that measure the same.
void share_bounds(const Problem& problem, Analysis& analysis);

}  // namespace pal::analyzer
