// The threads and devices that a requirement cannot be measured without (docs/slices.md).
#pragma once

#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// What is kept of a problem; the rest may do what it likes (slice.hpp).
struct Cone {
  std::vector<bool> threads;
  std::vector<bool> devices;
  /// Devices that only say how often others may take time: how seldom does not matter.
  std::vector<bool> pacers;

  /// Whether nothing is left out.
  bool whole() const;
};

/// Everything that carries what `requirement` measures, that can keep it from its processor, or that it waits
/// for again and again. `processor`: of a busy period. A load is of the whole problem.
Cone cone_of(const Problem& problem, const Requirement& requirement, int processor = -1);

}  // namespace pal::analyzer
