// Zeno runs: infinitely many events happen in no time.
#pragma once

#include <optional>

#include "analyzer/exact/exact.hpp"
#include "analyzer/zones/zone_graph.hpp"

namespace pal::analyzer {

struct ZenoSearch {
  /// A cycle on which no time passes. The concrete machine went round it: after a round everything is as it
  /// was before.
  std::optional<ZenoRun> found = {};
  /// There are such cycles of classes, but no run that goes round one of them is known.
  bool suspected = false;
  /// Whether none exists, if none was found; otherwise a search with wider limits may find one.
  bool excluded = false;
};

/// Cheap if each loop of each thread takes some time.
ZenoSearch find_zeno_run(const Problem& problem, const Limits& limits);

}  // namespace pal::analyzer
