// Whether a requirement holds, and no more: cheaper than its bound. Four ways, the cheapest first.
#pragma once

#include <functional>
#include <optional>

#include "analyzer/exact/exact.hpp"
#include "analyzer/whatif/ids.hpp"
#include "analyzer/zones/workers.hpp"

namespace pal::analyzer::whatif {

/// `holds` (also where no run measures anything) and `fails` are proved as by analyze(). Runs in which time
/// stands still (zeno_run.hpp) are left to the caller.
struct Decision {
  Verdict::State state = Verdict::State::undecided;
  std::optional<Witness> witness;  // fails; nothing if no single run is known, or of loads
  /// Load: the distance to the limit, in nanoseconds of work in a second. It is that of a load that no run
  /// exceeds (holds), or that a run attains (fails). Nothing: not known.
  std::optional<Nanoseconds> excess;
  bool grows = false;  // it fails by what has only grown by the end of the run
};

/// By its compositional `bound`, and by a few single runs with worst times: some milliseconds.
Decision decide_quickly(const Problem& problem, RequirementId requirement, const Verdict& bound,
                        const std::function<bool()>& stop);

/// By some hundreds of single runs, which can only refute.
Decision decide_by_runs(const Problem& problem, RequirementId requirement, std::size_t classes,
                        const std::function<bool()>& stop);

/// By exploring what has an influence (slice_bound.hpp), which can only prove.
Decision decide_by_slice(const Problem& problem, RequirementId requirement, const Options& options);

/// How many of the allowed classes are explored. It is fewer where there is more to do than there is time,
/// because such an exploration mostly has no end.
std::size_t classes_for(const Problem& problem, RequirementId requirement, std::size_t allowed);

/// By exploring all runs, in at most `options.max_states` classes. Values are followed up to the limit only,
/// and the exploration ends with the first run that is confirmed to exceed it.
Decision decide_by_exploration(const Problem& problem, RequirementId requirement, const Options& options,
                               Workers& workers);

/// Whether a run that fires as `script` does, at times of its own, breaks the requirement; `script` may come
/// from a problem with other figures. False says nothing, also where `stop` ended it.
bool refutes(const Problem& problem, RequirementId requirement, const Witness& witness,
             const std::function<bool()>& stop);

}  // namespace pal::analyzer::whatif
