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
  const std::set<int>& after(int step);
  bool reaches(int from, int to) { return from == to || after(from).contains(to); }
  /// The fork in `thread` that starts `block`, or the block above it; -1: `block` is none of the thread's.
  int fork_to(int thread, int block) const;

  const Problem& problem_;
  std::vector<int> started_by_;  // by thread: the fork; -1: none
  std::map<int, bool> again_;
  std::map<int, std::set<int>> after_;
};

}  // namespace pal::analyzer::compositional
