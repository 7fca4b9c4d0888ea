#include "analyzer/chart/labels.hpp"

#include <algorithm>

namespace pal::analyzer::chart {

bool Labels::free(const Box& box) const {
  return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) {
    return box.x0 < other.x1 && other.x0 < box.x1 && box.y0 < other.y1 && other.y0 < box.y1;
  });
}

bool Labels::claim(const Box& box) {
  if (!free(box)) return false;
  taken_.push_back(box);
  return true;
}

}  // namespace pal::analyzer::chart
