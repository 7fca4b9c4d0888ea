#include "sim/arm/joint_sensing.hpp"

#include <cmath>

#include "sim/random.hpp"

namespace pal::sim {
namespace {

// Below this part of the drive's greatest torque the motor stays where it lies in the play.
constexpr double least_push = 0.02;
// How fast the motor crosses the play, of what is left a millisecond: within about 20 ms.
constexpr double crossing = 0.05;
constexpr std::uint64_t counts_stream = 10;
constexpr std::uint64_t play_stream = 11;

}  // namespace

JointSensing::JointSensing(const MachineOptions& options) : options_(options) {
  Random counts(options.seed, counts_stream), sides(options.seed, play_stream);
  for (std::size_t i = 0; i < joint_count; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    origin_[row] = counts.unit();
    if (options.backlash) play_[row] = (sides.unit() < 0.5 ? -0.5 : 0.5) * gear_play[i];
  }
}

void JointSensing::advance(const Joints& torques) {
  if (!options_.backlash) return;
  for (std::size_t i = 0; i < joint_count; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (std::abs(torques[row]) < least_push * puma_limits[i].torque) continue;
    const double side = std::copysign(0.5 * gear_play[i], torques[row]);
    play_[row] += crossing * (side - play_[row]);
  }
}

Joints JointSensing::read(const Joints& joints) const {
  return nearest(joints + play_);
}

Joints JointSensing::nearest(const Joints& wanted) const {
  if (!options_.encoders) return wanted;
  Joints shown;
  for (std::size_t i = 0; i < joint_count; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    shown[row] =
        (std::round(wanted[row] * encoder_counts[i] - origin_[row]) + origin_[row]) / encoder_counts[i];
  }
  return shown;
}

}  // namespace pal::sim
