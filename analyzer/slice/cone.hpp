// The threads and devices that are needed to measure a requirement (docs/internals/slices.md).
#pragma once

#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// The parts of a problem that are kept; the rest may do anything (slice.hpp).
struct Cone {
  Table<ThreadId, bool> threads;
  Table<DeviceId, bool> devices;
  /// Devices that matter only because their events make others take time: how seldom they come does not
  /// matter.
  Table<DeviceId, bool> pacers;

  /// Whether nothing is left out.
  bool whole() const;
};

/// Whether a cone includes what its threads wait for again and again. Without that it is also sound, but
/// proves less.
enum class Reach { least, waits };

/// Everything that carries what `requirement` measures, that can keep it from its processor, or that it waits
/// for again and again. `processor`: of a busy period. For a load it is the whole problem.
Cone cone_of(const Problem& problem, const Requirement& requirement, ProcessorId processor = {},
             Reach reach = Reach::waits);

}  // namespace pal::analyzer
