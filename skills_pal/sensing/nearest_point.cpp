#include "skills_pal/sensing/nearest_point.hpp"

#include <array>
#include <cmath>

#include "skills_pal/sensing/line.hpp"

namespace pal::skills::sensing {
namespace {

constexpr double connected = 6;           // deviations between neighbours
constexpr double steepest_surface = 1.7;  // of a surface: 60 degrees
constexpr std::size_t seed_reach = 6;     // points on either side that a line begins with
constexpr std::array<std::size_t, 5> reaches{2, 6, 20, 40, 80};  // to which it goes on
constexpr double outlier = 4;                                    // deviations; counts no more than this
constexpr double uneven = 1.25;                                  // deviations, root mean square
constexpr std::size_t least_surface = 3;                         // points

bool connects(const Points& points, std::size_t i, double noise) {  // with i + 1
  const double allowed = connected * noise + steepest_surface * std::abs(points.y[i + 1] - points.y[i]);
  return std::abs(points.z[i + 1] - points.z[i]) < allowed;
}

// The points around `i` without a gap, up to a limit on either side.
Stretch around(const Points& points, std::size_t i, std::size_t left, std::size_t right, double noise) {
  Stretch stretch{i, i + 1};
  while (stretch.begin > 0 && i - stretch.begin < left && connects(points, stretch.begin - 1, noise)) {
    --stretch.begin;
  }
  while (stretch.end < points.count && stretch.end - i <= right && connects(points, stretch.end - 1, noise)) {
    ++stretch.end;
  }
  return stretch;
}

// Whether the points lie as evenly about the line as their noise has it: about a chord of a curve they do
// not.
bool straight(const Points& points, const LineOnStretch& fitted, double noise) {
  double squares = 0;
  for (std::size_t i = fitted.stretch.begin; i < fitted.stretch.end; ++i) {
    const double off = std::min(std::abs(points.z[i] - fitted.line.at(points.y[i])) / noise, outlier);
    squares += off * off;
  }
  return squares <= uneven * uneven * static_cast<double>(fitted.stretch.size());
}

// The longest straight line to the point: through it, or only on one side, where the nearest point is a
// ridge.
LineOnStretch line_at(const Points& points, std::size_t i, double noise) {
  LineOnStretch longest;
  for (const std::size_t reach : reaches) {
    for (const auto& [left, right] : {std::array<std::size_t, 2>{1, 1}, {1, 0}, {0, 1}}) {
      const auto sides = [&](std::size_t count) {
        return around(points, i, left * count, right * count, noise);
      };
      const Stretch seed = sides(std::min(seed_reach, reach));
      if (seed.size() < least_surface) continue;
      const LineOnStretch grown = grow_line(points, seed, sides(reach), noise);
      const bool usable = straight(points, grown, noise) || longest.stretch.size() == 0;
      if (usable && grown.stretch.size() > longest.stretch.size()) longest = grown;
    }
  }
  return longest;
}

}  // namespace

std::optional<NearestPoint> find_nearest_point(const Profile& profile) {
  Points points = valid_points(profile);
  const double noise = noise_of(points);
  points = without_spikes(points, noise);
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < points.count; ++i) {
    if (best && points.z[i] >= points.z[*best]) continue;
    if (around(points, i, seed_reach, seed_reach, noise).size() < least_surface) continue;
    best = i;
  }
  if (!best) return std::nullopt;
  // Of a surface that leans the nearest value is mostly not the nearest point, only the one with the luckiest
  // error.
  const LineOnStretch surface = line_at(points, *best, noise);
  const double first = points.y[surface.stretch.begin];
  const double last = points.y[surface.stretch.end - 1];
  const double y = surface.line.at(first) < surface.line.at(last) ? first : last;
  return NearestPoint{y, surface.line.at(y)};
}

}  // namespace pal::skills::sensing
