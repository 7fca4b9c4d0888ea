#include "sim/picture/peak_history.hpp"

#include <algorithm>

namespace pal::sim {

void PeakHistory::add(const HistoryPoint& point) {
  constexpr std::size_t most = 4096;
  // Of every second pair the higher one stays: peaks are what matters.
  if (points_.size() == most) {
    for (std::size_t i = 0; i < most / 2; ++i)
      points_[i] = points_[2 * i].second > points_[2 * i + 1].second ? points_[2 * i] : points_[2 * i + 1];
    points_.resize(most / 2);
  }
  points_.push_back(point);
  peak_ = std::max(peak_, point.second);
}

}  // namespace pal::sim
