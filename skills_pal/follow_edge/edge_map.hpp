// The edge as it was seen so far, in the frame in which the skill began.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <optional>

namespace pal::skills {

/// mm. The newest 64 points.
class EdgeMap {
 public:
  void start(double history) {
    count_ = 0;
    history_ = history;
  }

  /// `across`: along the surface beside the edge, square to the tool's x axis.
  void add(const Eigen::Vector3d& point, const Eigen::Vector3d& across);

  bool empty() const { return count_ == 0; }

  struct Place {
    Eigen::Vector3d point;
    Eigen::Vector3d along;   // unit vector
    Eigen::Vector3d across;  // unit vector along the surface beside it
  };
  /// The place of the edge in the plane through `where` that is square to `heading`. It is on a parabola
  /// through the points of the last `history` mm and of twice as much before, continued if need be. Nothing
  /// before a point was seen.
  std::optional<Place> at(const Eigen::Vector3d& where, const Eigen::Vector3d& heading) const;

 private:
  static constexpr std::size_t room = 64;
  struct Seen {
    Eigen::Vector3d point, across;
  };
  const Seen& newest(std::size_t back) const { return seen_[(next_ + room - 1 - back) % room]; }

  std::array<Seen, room> seen_;
  std::size_t next_ = 0;
  std::size_t count_ = 0;
  double history_ = 10;
};

}  // namespace pal::skills
