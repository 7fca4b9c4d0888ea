// Whole times that keep linear constraints, one of their differences being as great or as small as it can be.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// What an action that was interrupted has worked: the sum of t[end] - t[begin] over its pieces is in
/// `range`.
struct Work {
  std::vector<std::pair<std::size_t, std::size_t>> pieces;
  Range range;
};

/// t[to] - t[from] <= bound.
struct Difference {
  std::size_t from = 0;
  std::size_t to = 0;
  Nanoseconds bound = 0;
};

/// The difference t[to] - t[from] that is to be as great as it can be, if it is to be.
struct Goal {
  std::size_t from = 0;
  std::size_t to = 0;
  Nanoseconds enough = Range::unbounded;  // it is never greater, or more is not asked for
};

/// Times t[0] = 0, t[1], … in whole nanoseconds; nothing if there are none, or if the goal has no end.
/// Decided exactly, over the integers, by Z3 (L. de Moura, N. Bjorner, Z3: an efficient SMT solver, 2008).
/// After two seconds, or once `stop`, if given, says true, the best times so far; nothing, if none are known
/// by then, or there are too many (more than 2000 times, 1000 pieces).
std::optional<std::vector<Nanoseconds>> linear_times(std::size_t count,
                                                     const std::vector<Difference>& differences,
                                                     const std::vector<Work>& works,
                                                     const std::optional<Goal>& goal,
                                                     const std::function<bool()>& stop = {});

}  // namespace pal::analyzer
