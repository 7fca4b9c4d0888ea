// The zones seen at one place, arranged so that it is cheap to ask whether one of them contains another.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "analyzer/zones/dbm.hpp"

namespace pal::analyzer {

/// A summary that is compared before two zones are. A zone can only include another if each of its bounds is
/// at least the other's. Then the sum of its bounds is, too, and so are its bounds against zero, however they
/// are rounded.
struct Outline {
  std::int64_t sum = 0;
  std::vector<std::int32_t> bounds;

  void of(const Dbm& zone);
};

/// Outlines side by side, each with the number of its zone. They exclude most candidates. There may be very
/// many, as for a thread that goes round for long while something is measured. Then whole blocks of
/// neighbours are passed over, because zones that came one after the other are mostly alike.
class KnownZones {
 public:
  /// The first zone for which `includes(id)` is true, of those that may include that of `outline`; -1: none.
  template <class Includes>
  int first_around(const Outline& outline, const Includes& includes) const {
    const std::size_t width = outline.bounds.size();
    const std::int32_t* const sought = outline.bounds.data();
    for (std::size_t k = 0; k < ids_.size();) {
      if (summed_up(k, width) && !at_least(greatest_.data() + k / block * width, sought, width)) {
        k += block;
        continue;
      }
      for (const std::size_t end = std::min(ids_.size(), (k / block + 1) * block); k < end; ++k) {
        if (sums_[k] < outline.sum) continue;
        if (at_least(bounds_.data() + k * width, sought, width) && includes(ids_[k])) return ids_[k];
      }
    }
    return -1;
  }

  /// Removes those zones for which `lies_within(id)` is true, among those that the zone of `outline` may
  /// include.
  template <class LiesWithin>
  void erase_within(const Outline& outline, const LiesWithin& lies_within) {
    const std::size_t width = outline.bounds.size();
    const std::int32_t* const sought = outline.bounds.data();
    std::size_t kept = 0;
    std::size_t same = ids_.size();  // before it nothing was forgotten
    for (std::size_t k = 0; k < ids_.size();) {
      const std::size_t end = std::min(ids_.size(), (k / block + 1) * block);
      const bool none = summed_up(k, width) && !at_least(sought, least_.data() + k / block * width, width);
      if (none && kept == k) {
        kept = k = end;
        continue;
      }
      for (; k < end; ++k) {
        if (!none && sums_[k] <= outline.sum && at_least(sought, bounds_.data() + k * width, width) &&
            lies_within(ids_[k])) {
          same = std::min(same, k);
          continue;
        }
        if (kept != k) move(k, kept, width);
        ++kept;
      }
    }
    if (kept == ids_.size()) return;
    ids_.resize(kept);
    sums_.resize(kept);
    bounds_.resize(kept * width);
    least_.resize(std::min(least_.size(), same / block * width));
    greatest_.resize(least_.size());
    sum_up(width);
  }

  void add(int id, const Outline& outline) {
    ids_.push_back(id);
    sums_.push_back(outline.sum);
    bounds_.insert(bounds_.end(), outline.bounds.begin(), outline.bounds.end());
    sum_up(outline.bounds.size());
  }

  std::vector<int>& ids() { return ids_; }
  const std::vector<int>& ids() const { return ids_; }

 private:
  static constexpr std::size_t block = 512;

  static bool at_least(const std::int32_t* a, const std::int32_t* b, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (a[i] < b[i]) return false;
    }
    return true;
  }

  /// Whether the least and greatest bounds of the block that begins with zone `k` are
  /// known.
  bool summed_up(std::size_t k, std::size_t width) const { return (k / block + 1) * width <= least_.size(); }

  void move(std::size_t from, std::size_t to, std::size_t width) {
    ids_[to] = ids_[from];
    sums_[to] = sums_[from];
    for (std::size_t i = 0; i < width; ++i) bounds_[to * width + i] = bounds_[from * width + i];
  }

  /// Of each block that is full.
  void sum_up(std::size_t width);

  std::vector<int> ids_;
  std::vector<std::int64_t> sums_;
  std::vector<std::int32_t> bounds_;
  // By block: of each bound the least and the greatest.
  std::vector<std::int32_t> least_;
  std::vector<std::int32_t> greatest_;
};

}  // namespace pal::analyzer
