#include "skills_pal/sensing/line.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pal::skills::sensing {
namespace {

constexpr double tukey = 4.685;  // deviations at which a point has no weight: 95 % efficient for normal noise
constexpr int rounds = 5;
constexpr double near_the_line = 3.5;       // deviations
constexpr std::size_t misses_in_a_row = 3;  // end a line

// Of how far a point at y lies off a line that does not reach it yet, in deviations of one point.
double uncertainty(const Points& points, const LineOnStretch& fitted, double y) {
  double spread = 0;
  for (std::size_t i = fitted.stretch.begin; i < fitted.stretch.end; ++i) {
    spread += (points.y[i] - fitted.line.middle) * (points.y[i] - fitted.line.middle);
  }
  const double away = y - fitted.line.middle;
  return std::sqrt(1 + 1 / static_cast<double>(fitted.stretch.size()) + away * away / spread);
}

}  // namespace

double Line::angle() const {
  return std::atan(slope) * 180 / std::numbers::pi;
}

Line fit_line(const Points& points, Stretch stretch, double noise) {
  std::array<double, most_points> weight{};
  std::fill(weight.begin(), weight.end(), 1.0);
  Line line;
  for (int round = 0; round < rounds; ++round) {
    double sum = 0, y = 0, z = 0;
    for (std::size_t i = stretch.begin; i < stretch.end; ++i) {
      sum += weight[i];
      y += weight[i] * points.y[i];
      z += weight[i] * points.z[i];
    }
    if (sum <= 0) return line;  // every point left: keep the line before that
    double yy = 0, yz = 0;
    for (std::size_t i = stretch.begin; i < stretch.end; ++i) {
      const double dy = points.y[i] - y / sum;
      yy += weight[i] * dy * dy;
      yz += weight[i] * dy * (points.z[i] - z / sum);
    }
    line = {.slope = yy > 0 ? yz / yy : 0, .height = z / sum, .middle = y / sum};
    for (std::size_t i = stretch.begin; i < stretch.end; ++i) {
      const double off = (points.z[i] - line.at(points.y[i])) / (tukey * noise);
      weight[i] = std::abs(off) < 1 ? (1 - off * off) * (1 - off * off) : 0;
    }
  }
  return line;
}

LineOnStretch grow_line(const Points& points, Stretch seed, Stretch bounds, double noise) {
  LineOnStretch grown{fit_line(points, seed, noise), seed};
  const auto on = [&](std::size_t i) {
    const double off = points.z[i] - grown.line.at(points.y[i]);
    return std::abs(off) < near_the_line * noise * uncertainty(points, grown, points.y[i]);
  };
  std::size_t missed = 0;
  for (std::size_t i = seed.begin; i > bounds.begin && missed < misses_in_a_row; --i) {
    missed = on(i - 1) ? 0 : missed + 1;
    if (missed > 0) continue;
    grown.stretch.begin = i - 1;
    grown.line = fit_line(points, grown.stretch, noise);
  }
  missed = 0;
  for (std::size_t i = seed.end; i < bounds.end && missed < misses_in_a_row; ++i) {
    missed = on(i) ? 0 : missed + 1;
    if (missed > 0) continue;
    grown.stretch.end = i + 1;
    grown.line = fit_line(points, grown.stretch, noise);
  }
  return grown;
}

StretchSums::StretchSums(const Points& points) {
  if (points.count == 0) return;
  // Counted from a point in the middle: sums of squares of small numbers keep their digits.
  const double y0 = points.y[points.count / 2];
  const double z0 = points.z[points.count / 2];
  for (std::size_t i = 0; i < points.count; ++i) {
    const double y = points.y[i] - y0;
    const double z = points.z[i] - z0;
    const Sums& s = sums_[i];
    sums_[i + 1] = {s.y + y, s.z + z, s.yy + y * y, s.yz + y * z, s.zz + z * z};
  }
}

double StretchSums::residual(Stretch stretch) const {
  const Sums& a = sums_[stretch.begin];
  const Sums& b = sums_[stretch.end];
  const auto n = static_cast<double>(stretch.size());
  const double y = b.y - a.y;
  const double z = b.z - a.z;
  const double yy = b.yy - a.yy - y * y / n;
  const double yz = b.yz - a.yz - y * z / n;
  const double zz = b.zz - a.zz - z * z / n;
  return std::max(0.0, yy > 0 ? zz - yz * yz / yy : zz);
}

}  // namespace pal::skills::sensing
