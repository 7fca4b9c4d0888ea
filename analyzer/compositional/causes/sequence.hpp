// Which segments of a module can follow which.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "analyzer/compositional/causes/segment.hpp"

namespace pal::analyzer::compositional {

/// The order of the steps of a module's threads, as its program gives it.
class Sequence {
 public:
  explicit Sequence(const Problem& problem);

  /// Whether `later` may begin or run after `earlier` has begun.
  bool may_follow(const Beginning& earlier, const Beginning& later);

 private:
  const std::set<StepId>& after(StepId step);
  bool reaches(StepId from, StepId to) { return from == to || after(from).contains(to); }
  /// The fork in `thread` that starts `block`, or the block above it; none: `block` is none of the thread's.
  StepId fork_to(ThreadId thread, ThreadId block) const;

  const Problem& problem_;
  Table<ThreadId, StepId> started_by_;  // the fork
  std::map<ThreadId, bool> again_;
  std::map<StepId, std::set<StepId>> after_;
};

}  // namespace pal::analyzer::compositional
