#include "analyzer/zones/known_zones.hpp"

#include <algorithm>

namespace pal::analyzer {

void Outline::of(const Dbm& zone) {
  // Cut, so that no sum overflows; what is greater stays at least as great.
  constexpr std::int64_t most = std::int64_t{1} << 46U;
  const auto rounded = [](std::int64_t bound) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(bound >> 10U, INT32_MIN, INT32_MAX));
  };
  sum = 0;
  for (std::size_t i = 0; i < zone.size(); ++i) {
    for (std::size_t j = 0; j < zone.size(); ++j) sum += std::clamp(zone.at(i, j), -most, most);
  }
  bounds.clear();
  for (std::size_t i = 1; i < zone.size(); ++i) {
    bounds.push_back(rounded(zone.at(i, 0)));
    bounds.push_back(rounded(zone.at(0, i)));
  }
}

void KnownZones::sum_up(std::size_t width) {
  if (width == 0) return;
  for (std::size_t k = least_.size() / width * block; k + block <= ids_.size(); k += block) {
    const std::size_t first = least_.size();
    const auto bounds = bounds_.begin() + static_cast<std::ptrdiff_t>(k * width);
    least_.insert(least_.end(), bounds, bounds + static_cast<std::ptrdiff_t>(width));
    greatest_.insert(greatest_.end(), bounds, bounds + static_cast<std::ptrdiff_t>(width));
    for (std::size_t i = width; i < block * width; ++i) {
      const std::int32_t bound = bounds_[k * width + i];
      least_[first + i % width] = std::min(least_[first + i % width], bound);
      greatest_[first + i % width] = std::max(greatest_[first + i % width], bound);
    }
  }
}

}  // namespace pal::analyzer
