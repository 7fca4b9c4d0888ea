#include "sim/controller/gripper_servo.hpp"

#include <algorithm>
#include <cmath>

#include "sim/arm/tool.hpp"

namespace pal::sim {
namespace {

constexpr double gripper_period = 1e-3;  // s
constexpr double rate = 0.05;            // m/s of one finger
constexpr double inertia = 0.16;         // kg, finger and drive (sim/model/tools/gripper.xml)
constexpr double friction = 20.0;        // N*s/m, the same
constexpr double gripper_natural = 150;  // rad/s, of the closed loop
constexpr double least_width = -10;      // mm: closing presses the fingers on each other

}  // namespace

void GripperServo::command(double now, double width, double force) {
  wanted_ = now / 2e3;
  target_ = std::clamp(width, least_width, gripper_opening) / 2e3;
  limit_ = std::max(force, 0.0);
}

std::array<double, 2> GripperServo::forces(const std::array<double, 2>& opening,
                                           const std::array<double, 2>& speed) {
  const double way = std::clamp(target_ - wanted_, -rate * gripper_period, rate * gripper_period);
  wanted_ += way;
  const double mean = 0.5 * (opening[0] + opening[1]), mean_speed = 0.5 * (speed[0] + speed[1]);
  const double force = inertia * gripper_natural * gripper_natural * (wanted_ - mean) +
                       2 * inertia * gripper_natural * (way / gripper_period - mean_speed) +
                       friction * way / gripper_period;
  const double limited = std::clamp(force, -limit_, limit_);
  return {limited, limited};
}

}  // namespace pal::sim
