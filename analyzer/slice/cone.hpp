// The threads and devices that a requirement cannot be measured without (docs/internals/slices.md).
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

/// Whether a cone goes on to what its threads wait for again and again. Without that it is as sound, and says
/// less.
enum class Reach { least, waits };

/// Everything that carries what `requirement` measures, that can keep it from its processor, or that it waits
/// for again and again. `processor`: of a busy period. A load is of the whole problem.
Cone cone_of(const Problem& problem, const Requirement& requirement, int processor = -1,
             Reach reach = Reach::waits);

}  // namespace pal::analyzer
