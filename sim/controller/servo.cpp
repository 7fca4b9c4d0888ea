#include "sim/controller/servo.hpp"

#include <algorithm>
#include <cmath>

namespace pal::sim {
namespace {

constexpr double period = 1e-3;         // s
constexpr double natural = 200;         // rad/s, of the closed loop: the position loop follows within 10 ms
constexpr double integral_rate = 15.0;  // 1/s

struct Drive {
  double inertia;  // kg*m^2 at the joint, arm stretched half way: what the gains are made for
  double coulomb;  // N*m
  double viscous;  // N*m*s/rad
};

// Friction as in sim/scenes/puma560.xml.
constexpr std::array<Drive, joint_count> drives{{{3.5, 26.0, 5.80},
                                                 {5.0, 10.6, 9.49},
                                                 {1.0, 6.4, 3.98},
                                                 {0.20, 1.07, 0.411},
                                                 {0.18, 0.85, 0.427},
                                                 {0.195, 0.55, 0.216}}};

// Full friction from this speed on; below it the sign of a set-point that hardly moves must not shake the
// joint.
constexpr double friction_speed = 1e-3;  // rad/s

}  // namespace

Joints JointServos::torques(const SetPoint& wanted, const Joints& position, const Joints& speed,
                            const Joints& load) {
  Joints result;
  for (std::size_t i = 0; i < joint_count; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Drive& drive = drives[i];
    const double limit = puma_limits[i].torque;
    const double stiffness = drive.inertia * natural * natural;
    const double damping = 2.0 * drive.inertia * natural;
    const double error = wanted.position[row] - position[row];
    const double friction = drive.coulomb * std::clamp(wanted.speed[row] / friction_speed, -1.0, 1.0) +
                            drive.viscous * wanted.speed[row];
    const double torque = load[row] + friction + stiffness * error +
                          damping * (wanted.speed[row] - speed[row]) + integral_[row];
    // The integral stands while the drive gives all it has.
    if (std::abs(torque) < limit) integral_[row] += stiffness * integral_rate * error * period;
    result[row] = std::clamp(torque, -limit, limit);
  }
  return result;
}

void JointServos::reset() {
  integral_.setZero();
}

}  // namespace pal::sim
