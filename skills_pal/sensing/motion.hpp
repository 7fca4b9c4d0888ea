// Where the tool was while a profile was taken.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <span>

#include "skills_pal/sensing/profile.hpp"

namespace pal::skills::sensing {

/// How a scan goes on in time: point i is taken at its beginning + first_point + i · scan_time / 255 (ms).
inline constexpr double scan_time = 76;
inline constexpr double first_point = 0.05;
constexpr double point_time(std::size_t i) {
  return first_point + scan_time * static_cast<double>(i) / static_cast<double>(most_points);
}

/// Poses of the tool at instants, in any one frame that stays where it is; mm. Keeps the newest 64.
class ToolMotion {
 public:
  void clear() { count_ = 0; }
  /// Instants (ms) must rise; one that does not is ignored.
  void add(double instant, const Eigen::Isometry3d& pose);
  bool empty() const { return count_ == 0; }
  /// In between instants in a straight line, turning evenly; before the first and after the last like the
  /// nearest. Not of an empty motion.
  Eigen::Isometry3d at(double instant) const;

 private:
  struct Known {
    double instant = 0;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  };
  static constexpr std::size_t room = 64;
  const Known& known(std::size_t i) const { return ring_[(first_ + i) % room]; }

  std::array<Known, room> ring_;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

/// The valid points of a profile whose scan began at `taken` (ms), as seen from the tool's pose at `instant`.
/// So the profile of a tool that moved becomes one as if the tool had stood still, but with an x for each
/// point. Returns the number of points; `points` has room for all of the profile. Without any motion: all at
/// x = 0.
std::size_t compensate(const Profile& profile, double taken, const ToolMotion& motion, double instant,
                       std::span<Eigen::Vector3d> points);

}  // namespace pal::skills::sensing
