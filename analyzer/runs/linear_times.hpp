// Whole times that satisfy linear constraints, with one difference of them as great or as small as possible.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// The work of an interrupted action: the sum of t[end] - t[begin] over its pieces is in `range`.
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

/// The difference t[to] - t[from] to maximise, if there is one.
struct Goal {
  std::size_t from = 0;
  std::size_t to = 0;
  Nanoseconds enough = Range::unbounded;  // it is never greater, or more is not asked for
  bool less_will_not_do = false;          // below `enough` one is as good as another
};

/// Times t[0] = 0, t[1], … in whole nanoseconds; nothing if there are none, or if the goal is unbounded.
/// Decided exactly, over the integers, by Z3 (L. de Moura, N. Bjorner, Z3: an efficient SMT solver, 2008).
/// After two seconds, or once `stop`, if given, returns true: the best times so far, or nothing if none are
/// known. Nothing also if there are too many (more than 2000 times, 1000 pieces).
std::optional<std::vector<Nanoseconds>> linear_times(std::size_t count,
                                                     const std::vector<Difference>& differences,
                                                     const std::vector<Work>& works,
                                                     const std::optional<Goal>& goal,
                                                     const std::function<bool()>& stop = {});

}  // namespace pal::analyzer
