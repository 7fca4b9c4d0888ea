#include "skills_pal/sensing/profile.hpp"

#include <algorithm>
#include <cmath>

namespace pal::skills::sensing {
namespace {

constexpr double spike = 6;                            // deviations
constexpr double steepest_seen = 1.7;                  // of a surface: 60 degrees
constexpr double step = 0.1;                           // mm
constexpr double beyond_noise = 4;                     // deviations
constexpr double median_to_deviation = 1.4826;         // of normally distributed values
constexpr double middle_to_point = 1.224744871391589;  // sqrt(3/2): a point, and the mean of two

}  // namespace

Points valid_points(const Profile& profile) {
  Points points;
  for (std::size_t i = 0; i < std::min(profile.size(), most_points); ++i) {
    if (!profile.valid[i]) continue;
    points.y[points.count] = profile.y[i];
    points.z[points.count] = profile.z[i];
    points.index[points.count] = i;
    ++points.count;
  }
  return points;
}

Points without_spikes(const Points& points, double noise) {
  Points kept;
  for (std::size_t i = 0; i < points.count; ++i) {
    if (i > 0 && i + 1 < points.count) {
      const double apart = std::abs(points.z[i + 1] - points.z[i - 1]);
      const double off = std::abs(points.z[i] - (points.z[i + 1] + points.z[i - 1]) / 2);
      const double allowed = spike * noise + steepest_seen * std::abs(points.y[i + 1] - points.y[i - 1]);
      if (apart < allowed && off > allowed) continue;
    }
    kept.y[kept.count] = points.y[i];
    kept.z[kept.count] = points.z[i];
    kept.index[kept.count] = points.index[i];
    ++kept.count;
  }
  return kept;
}

Points without_wall_points(const Points& points, double noise) {
  Points kept;
  for (std::size_t i = 0; i < points.count; ++i) {
    if (i > 0 && i + 1 < points.count && points.index[i + 1] > points.index[i] + 1) {
      const double allowed = spike * noise + steepest_seen * std::abs(points.y[i] - points.y[i - 1]);
      if (points.z[i - 1] - points.z[i] > allowed) continue;
    }
    kept.y[kept.count] = points.y[i];
    kept.z[kept.count] = points.z[i];
    kept.index[kept.count] = points.index[i];
    ++kept.count;
  }
  return kept;
}

double noise_of(const Points& points) {
  const double least = step / std::sqrt(12.0);
  if (points.count < 5) return least;
  std::array<double, most_points> off{};
  const std::size_t count = points.count - 2;
  for (std::size_t i = 0; i < count; ++i) {
    off[i] = std::abs(points.z[i + 1] - (points.z[i] + points.z[i + 2]) / 2);
  }
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(off.begin(), middle, off.begin() + static_cast<std::ptrdiff_t>(count));
  // The median comes in whole and half steps; it only says what is no noise. What remains is squared.
  const double limit = beyond_noise * std::max(least, median_to_deviation * *middle);
  double squares = 0;
  double counted = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (off[i] > limit) continue;
    squares += off[i] * off[i];
    counted += 1;
  }
  return std::max(least, std::sqrt(squares / counted) / middle_to_point);
}

}  // namespace pal::skills::sensing
