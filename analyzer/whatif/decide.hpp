// Whether a requirement holds, and no more: cheaper than its bound.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "analyzer/exact/exact.hpp"

namespace pal::analyzer {

/// `holds` (also where no run measures anything) and `fails` are proved as by analyze(). Values are followed
/// up to the limit only, and the exploration ends with the first run that is confirmed to exceed it; that is
/// the witness.
struct Decision {
  Verdict::State state = Verdict::State::undecided;
  std::optional<Witness> witness;  // fails; nothing if a simulation sufficed, or of loads
  /// Load: by how much one that no run exceeds (holds) or that a run attains (fails) is over the limit, in
  /// nanoseconds of work in a second. Nothing: not known.
  std::optional<Nanoseconds> excess;
  bool grows = false;  // it fails by what has only grown by the end of the run
};
/// `bound`: what the compositional analysis says of it.
Decision decide(const Problem& problem, std::size_t requirement, const Verdict& bound, const Options& options,
                Workers& workers);

/// Whether a run that fires as `script` does, at times of its own, breaks the requirement; `script` may come
/// from a problem with other figures. False says nothing, also where `stop` ended it.
bool refutes(const Problem& problem, std::size_t requirement, const Witness& witness,
             const std::function<bool()>& stop);

}  // namespace pal::analyzer
