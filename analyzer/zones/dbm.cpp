#include "analyzer/zones/dbm.hpp"

#include <algorithm>

namespace pal::analyzer {

bool Dbm::constrain(std::size_t i, std::size_t j, std::int64_t bound) {
  if (bound >= at(i, j)) return true;
  if (sum(bound, at(j, i)) < 0) return false;
  at(i, j) = bound;
  for (std::size_t a = 0; a < size_; ++a) {
    const std::int64_t to_j = sum(at(a, i), bound);
    if (to_j >= unbounded) continue;
    for (std::size_t b = 0; b < size_; ++b) {
      const std::int64_t through = sum(to_j, at(j, b));
      if (through < at(a, b)) at(a, b) = through;
    }
  }
  return true;
}

bool Dbm::includes(const Dbm& other) const {
  return std::equal(bounds_.begin(), bounds_.end(), other.bounds_.begin(), other.bounds_.end(),
                    [](std::int64_t mine, std::int64_t theirs) { return mine >= theirs; });
}

}  // namespace pal::analyzer
