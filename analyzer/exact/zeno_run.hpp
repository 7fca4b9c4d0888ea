// Zeno runs: infinitely many events happen in no time.
#pragma once

#include <optional>

#include "analyzer/exact/exact.hpp"
#include "analyzer/zones/zone_graph.hpp"

namespace pal::analyzer {

struct ZenoSearch {
  /// A reachable cycle on which no time can pass.
  std::optional<ZenoRun> found = {};
  /// Whether none exists, if none was found; otherwise a search with wider limits may find one.
  bool excluded = false;
};

/// Cheap if each loop of each thread takes some time.
ZenoSearch find_zeno_run(const Problem& problem, const Limits& limits);

}  // namespace pal::analyzer
