#include "skills_pal/follow_edge/edge_map.hpp"

#include <algorithm>
#include <cmath>

namespace pal::skills {

void EdgeMap::add(const Eigen::Vector3d& point, const Eigen::Vector3d& across) {
  seen_[next_] = {point, across};
  next_ = (next_ + 1) % room;
  count_ = std::min(count_ + 1, room);
}

std::optional<EdgeMap::Place> EdgeMap::at(const Eigen::Vector3d& where,
                                          const Eigen::Vector3d& heading) const {
  if (count_ == 0) return std::nullopt;
  const auto along = [&](const Eigen::Vector3d& point) { return (point - where).dot(heading); };
  const double newest_s = along(newest(0).point);
  std::size_t used = 1;
  while (used < count_ && newest_s - along(newest(used).point) <= 2 * history_) ++used;
  // Of a short piece the direction is noise, and of one that is not long the bend is.
  const double length = newest_s - along(newest(used - 1).point);
  const bool directed = used >= 4 && length >= history_ / 2;
  const bool bends = used >= 6 && length >= 1.5 * history_;

  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d right = Eigen::Matrix3d::Zero();  // rows: powers of s; columns: x y z
  Eigen::Vector3d across = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < used; ++i) {
    const Seen& seen = newest(i);
    const double s = along(seen.point);
    const double weight = newest_s - s <= history_ ? 1.0 : 0.5;
    const Eigen::Vector3d powers(1, directed ? s : 0, bends ? s * s : 0);
    const Eigen::Vector3d off = seen.point - where - (directed ? 0 : s) * heading;
    normal += weight * powers * powers.transpose();
    right += weight * powers * off.transpose();
    if (newest_s - s <= history_) across += seen.across;
  }
  if (!directed) normal(1, 1) = 1;
  if (!bends) normal(2, 2) = 1;
  const Eigen::Matrix3d law = normal.ldlt().solve(right);
  Place place;
  place.point = where + law.row(0).transpose();
  place.along = directed ? Eigen::Vector3d(law.row(1).transpose()).normalized() : heading;
  place.across = across.normalized();
  return place;
}

}  // namespace pal::skills
