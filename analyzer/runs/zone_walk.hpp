// Looks for a bad run by walks through zones. At each step one of the events that can come next is drawn;
// when it comes stays open. So what must meet within a short time meets as often as what has much time.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "analyzer/runs/witness.hpp"

namespace pal::analyzer {

struct ZoneWalkOptions {
  std::size_t steps = 20'000;  // in all walks together
  std::size_t length = 300;    // of one walk, from where it leaves the best one
  std::function<bool()> stop;  // asked at each step
};

/// A run that breaks `requirement` (no load), replayed; nothing, if none is found. Most walks go on from some
/// step of the one that measured the worst value by then. The same problem gives the same run.
std::optional<Witness> walk_zones(const Problem& problem, const Requirement& requirement,
                                  const ZoneWalkOptions& options);

}  // namespace pal::analyzer
