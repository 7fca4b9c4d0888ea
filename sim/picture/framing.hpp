// The place of a camera from which everything is in the picture. Private to pal_sim.
#pragma once

#include <Eigen/Dense>

namespace pal::sim {

/// A camera: it stands `distance` behind the point that it looks at. Angles in degrees, lengths in metres,
/// the world's frame: azimuth 0 looks along x, 90 along y; a negative elevation looks down.
struct View {
  double azimuth = 90;
  double elevation = -20;
  double opening = 30;  // vertical
  double distance = 1;
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  /// A camera of the model, by its number, instead of all this; -1: none.
  int fixed = -1;

  Eigen::Vector3d forward() const;
  Eigen::Vector3d right() const;
  Eigen::Vector3d up() const;
  Eigen::Vector3d eye() const { return target - distance * forward(); }
};

/// The nearest place, for one direction of view, from which all points are in the picture. Any number of
/// points may be added, because only four maxima are kept.
class Framing {
 public:
  /// `aspect`: width by height. `margin`: the part of the picture's half width and half height that stays
  /// free.
  Framing(double azimuth, double elevation, double opening, double aspect, double margin);

  void include(const Eigen::Vector3d& point);
  /// Contract: at least one point.
  View view() const;

 private:
  View direction_;
  double across_, along_;  // what the picture shows to one side, at distance 1
  double left_ = -1e300, right_ = -1e300, low_ = -1e300, high_ = -1e300;
};

}  // namespace pal::sim
