// A profile of the range finder, as logical sensors look at it. Nothing in this library allocates.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace pal::skills::sensing {

/// The range finder's points in one profile: no profile is longer.
inline constexpr std::size_t most_points = 255;

/// Points in the order of the scan, mm. The message calls `y` x: it lies along the tool's y axis. The three
/// are of one length, at most most_points; what is not valid means nothing.
struct Profile {
  std::span<const double> y;
  std::span<const double> z;
  std::span<const bool> valid;

  std::size_t size() const { return z.size(); }
};

/// The valid points of a profile, in its order.
struct Points {
  std::array<double, most_points> y{};
  std::array<double, most_points> z{};
  std::array<std::size_t, most_points> index{};  // in the profile
  std::size_t count = 0;
};

Points valid_points(const Profile& profile);
/// Without single points that lie far off the middle between their neighbours while these two agree.
Points without_spikes(const Points& points, double noise);
/// Without single points on a wall below a nearer surface: much nearer than the point before, and followed by
/// one that is not valid. They belong to neither surface.
Points without_wall_points(const Points& points, double noise);

/// Standard deviation of the noise in z, mm. It is computed from how far each point lies off the middle
/// between its neighbours. The median of these distances is taken, so edges do not count. Never less than the
/// noise of the range finder's own steps.
double noise_of(const Points& points);

/// |fz| as the thesis counts it: the sensor feels a negative fz when the tool presses; this is how hard it
/// presses.
constexpr double z_force(double fz) {
  return -fz;
}

}  // namespace pal::skills::sensing
