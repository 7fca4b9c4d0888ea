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

}  // namespace pal::analyzer
