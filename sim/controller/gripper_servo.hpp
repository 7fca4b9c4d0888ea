// The gripper's own controller: opens to a width, or closes until it has its force.
#pragma once

#include <array>

namespace pal::sim {

/// Both fingers get the same force: they are coupled, and only the width between them is controlled.
class GripperServo {
 public:
  /// From the width that the fingers have now (mm) to `width`, at 100 mm/s, with at most `force` (N) on each
  /// finger.
  void command(double now, double width, double force);

  /// The force on each finger along its way outwards, N. Called once each millisecond with the openings of
  /// the fingers, m and m/s.
  std::array<double, 2> forces(const std::array<double, 2>& opening, const std::array<double, 2>& speed);

 private:
  double wanted_ = 40e-3;  // opening of one finger, m
  double target_ = 40e-3;
  double limit_ = 30;  // N
};

}  // namespace pal::sim
