// The least bound on a load that shares of the time can prove.
#pragma once

#include <functional>
#include <optional>

#include "analyzer/load/fraction.hpp"
#include "analyzer/load/work_graph.hpp"

namespace pal::analyzer {

/// A fraction of time that no unending run in the recurrence exceeds. It is the least one that shares prove.
/// If the numbers grow too long, it is one part in 10^12 more. `limit`: the search ends with nothing once the
/// least is known to be above it. Nothing also if it takes too long. The shares come from linear programming,
/// cycle by cycle (J. E. Kelley, The cutting-plane method for solving convex programs, 1960). That they prove
/// the bound is checked in whole numbers.
std::optional<Fraction> share_bound(const WorkGraph& graph, const std::optional<Fraction>& limit,
                                    const std::function<bool()>& stop);

}  // namespace pal::analyzer
