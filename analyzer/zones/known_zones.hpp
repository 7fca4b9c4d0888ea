// The zones seen at one place, so arranged that the question whether one of them holds another is cheap.
#pragma once

#include <cstdint>
#include <vector>

#include "analyzer/zones/dbm.hpp"

namespace pal::analyzer {

/// What is looked at before two zones are compared. A zone can only include another if each of its bounds is
/// at least the other's: then the sum of its bounds is, and its bounds against zero are, however they are
/// rounded.
struct Outline {
  std::int64_t sum = 0;
  std::vector<std::int32_t> bounds;

  void of(const Dbm& zone);
};

/// Outlines side by side, each with the number of its zone. Most candidates go no further.
class KnownZones {
 public:
  /// The first zone for which `includes(id)` is true, of those that may include that of `outline`; -1: none.
  template <class Includes>
  int first_around(const Outline& outline, const Includes& includes) const {
    const std::size_t width = outline.bounds.size();
    for (std::size_t k = 0; k < ids_.size(); ++k) {
      if (sums_[k] < outline.sum) continue;
      if (at_least(bounds_.data() + k * width, outline.bounds.data(), width) && includes(ids_[k])) return ids_[k];
    }
    return -1;
  }

  /// Forgets those for which `lies_within(id)` is true, of those that the zone of `outline` may include.
  template <class LiesWithin>
  void erase_within(const Outline& outline, const LiesWithin& lies_within) {
    const std::size_t width = outline.bounds.size();
    std::size_t kept = 0;
    for (std::size_t k = 0; k < ids_.size(); ++k) {
      if (sums_[k] <= outline.sum && at_least(outline.bounds.data(), bounds_.data() + k * width, width) &&
          lies_within(ids_[k]))
        continue;
      if (kept != k) {
        ids_[kept] = ids_[k];
        sums_[kept] = sums_[k];
        for (std::size_t i = 0; i < width; ++i) bounds_[kept * width + i] = bounds_[k * width + i];
      }
      ++kept;
    }
    ids_.resize(kept);
    sums_.resize(kept);
    bounds_.resize(kept * width);
  }

  void add(int id, const Outline& outline) {
    ids_.push_back(id);
    sums_.push_back(outline.sum);
    bounds_.insert(bounds_.end(), outline.bounds.begin(), outline.bounds.end());
  }

  std::vector<int>& ids() { return ids_; }
  const std::vector<int>& ids() const { return ids_; }

 private:
  static bool at_least(const std::int32_t* a, const std::int32_t* b, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (a[i] < b[i]) return false;
    }
    return true;
  }

  std::vector<int> ids_;
  std::vector<std::int64_t> sums_;
  std::vector<std::int32_t> bounds_;
};

}  // namespace pal::analyzer
