// A figure against time, as much of it as a strip of a picture can show.
#pragma once

#include <utility>
#include <vector>

namespace pal::sim {

/// s, and N or mm.
using HistoryPoint = std::pair<double, double>;

/// Keeps up to 4096 points, and every peak among them.
class PeakHistory {
 public:
  void add(const HistoryPoint& point);
  const std::vector<HistoryPoint>& points() const { return points_; }
  double peak() const { return peak_; }

 private:
  std::vector<HistoryPoint> points_;
  double peak_ = 0;
};

}  // namespace pal::sim
