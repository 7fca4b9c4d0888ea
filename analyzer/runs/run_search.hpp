// Looks for a bad run where not all runs can be explored. A run that it finds is a fact; if it finds none,
// that proves nothing.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "analyzer/runs/witness.hpp"

namespace pal::analyzer {

struct RunSearchOptions {
  std::size_t drawn = 16;            // runs by chance
  std::size_t steady = 0;            // runs by chance in which loops go on for long
  std::size_t runs = 400;            // at most, in all
  std::size_t max_events = 600;      // of each
  std::optional<Nanoseconds> bound;  // no run goes beyond it: one that attains it is the worst
  std::function<bool()> stop;        // asked between runs
};

/// Of the runs tried, the one in which `requirement` (no load) comes nearest to failing, or fails first;
/// nothing if none measures anything. First, random runs are made, then steady ones until the requirement
/// fails. Then devices are moved one by one to instants at which something happens while the greatest value
/// grows, as long as that makes it greater. Of promising runs the order of events is kept, and their times
/// are chosen again to make the value as great as possible (witness_along). The same problem gives the same
/// run.
std::optional<Witness> search_runs(const Problem& problem, const Requirement& requirement,
                                   const RunSearchOptions& options);

}  // namespace pal::analyzer
