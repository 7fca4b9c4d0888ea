#include "skills_pal/sensing/motion.hpp"

#include <algorithm>

namespace pal::skills::sensing {

void ToolMotion::add(double instant, const Eigen::Isometry3d& pose) {
  if (count_ > 0 && instant <= known(count_ - 1).instant) return;
  if (count_ == room) {
    first_ = (first_ + 1) % room;
    --count_;
  }
  ring_[(first_ + count_++) % room] = {instant, pose};
}

Eigen::Isometry3d ToolMotion::at(double instant) const {
  std::size_t after = 0;
  while (after < count_ && known(after).instant < instant) ++after;
  if (after == 0) return known(0).pose;
  if (after == count_) return known(count_ - 1).pose;
  const Known& a = known(after - 1);
  const Known& b = known(after);
  const double part = (instant - a.instant) / (b.instant - a.instant);
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(a.pose.linear()).slerp(part, Eigen::Quaterniond(b.pose.linear()));
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = turn.toRotationMatrix();
  pose.translation() = (1 - part) * a.pose.translation() + part * b.pose.translation();
  return pose;
}

std::size_t compensate(const Profile& profile, double taken, const ToolMotion& motion, double instant,
                       std::span<Eigen::Vector3d> points) {
  const Eigen::Isometry3d from_space =
      motion.empty() ? Eigen::Isometry3d::Identity() : motion.at(instant).inverse();
  std::size_t count = 0;
  for (std::size_t i = 0; i < profile.size() && count < points.size(); ++i) {
    if (!profile.valid[i]) continue;
    const Eigen::Isometry3d to_space =
        motion.empty() ? Eigen::Isometry3d::Identity() : motion.at(taken + point_time(i));
    points[count++] = from_space * (to_space * Eigen::Vector3d(0, profile.y[i], profile.z[i]));
  }
  return count;
}

}  // namespace pal::skills::sensing
