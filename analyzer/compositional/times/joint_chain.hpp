// Consecutive segments of one occurrence that keep one processor busy from the first release to the last end.
#pragma once

#include "analyzer/compositional/times/interference.hpp"

namespace pal::analyzer::compositional {

/// The longest chain of nodes that ends with `node`, the first one first; `node` alone if there is no longer
/// one. All are on one preemptive processor, and each is ready at the instant at which the one before it
/// sends. `times` has its nodes, its unbounded and its blocked threads.
std::vector<NodeId> joint_chain(const AnalysisContext& context, const Times& times, NodeId node);

/// The end (suffix) of a chain whose bound is the earliest. `after` is the time from the release of its first
/// node until the first `part` of the last node's work is done.
struct JointEnd {
  std::vector<NodeId> chain;
  Nanoseconds after = never;
};

/// Every end of `chain` with more than one node; `released` says when a node is released at the latest. No
/// chain: nothing has a bound.
template <class Released>
JointEnd soonest_joint_end(const Interference& interference, std::vector<NodeId> chain, Nanoseconds part,
                           const Released& released) {
  JointEnd found;
  Nanoseconds soonest = never;
  for (; chain.size() > 1; chain.erase(chain.begin())) {
    const Nanoseconds after = interference.joint_finish(chain, part);
    const Nanoseconds end = plus(released(chain.front()), after);
    if (end >= soonest) continue;
    soonest = end;
    found = {chain, after};
  }
  return found;
}

}  // namespace pal::analyzer::compositional
