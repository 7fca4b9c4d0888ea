#include <cmath>

#include "sim/arm/puma.hpp"
#include "sim/picture/framing.hpp"

namespace pal::sim {

Eigen::Vector3d View::forward() const {
  const double a = radians(azimuth), e = radians(elevation);
  return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

Eigen::Vector3d View::right() const {
  const double a = radians(azimuth);
  return {std::sin(a), -std::cos(a), 0};
}

Eigen::Vector3d View::up() const {
  return right().cross(forward());
}

Framing::Framing(double azimuth, double elevation, double opening, double aspect, double margin)
    : direction_{.azimuth = azimuth, .elevation = elevation, .opening = opening},
      across_(std::tan(radians(opening) / 2) * aspect * (1 - margin)),
      along_(std::tan(radians(opening) / 2) * (1 - margin)) {}

// The eye is at (x, y, d) in the camera's axes, with d counted against the direction of looking. A point is
// in the picture if |px - x| <= across * (d - pd), and likewise upwards. Each side gives one bound on the
// eye.
void Framing::include(const Eigen::Vector3d& point) {
  const double x = point.dot(direction_.right());
  const double y = point.dot(direction_.up());
  const double back = -point.dot(direction_.forward());
  right_ = std::max(right_, x + across_ * back);
  left_ = std::max(left_, -x + across_ * back);
  high_ = std::max(high_, y + along_ * back);
  low_ = std::max(low_, -y + along_ * back);
}

View Framing::view() const {
  const double x = (right_ - left_) / 2;
  const double y = (high_ - low_) / 2;
  const double back = std::max((right_ + left_) / (2 * across_), (high_ + low_) / (2 * along_));
  View view = direction_;
  const Eigen::Vector3d eye = x * view.right() + y * view.up() - back * view.forward();
  view.distance = 1;
  view.target = eye + view.forward();
  return view;
}

}  // namespace pal::sim
