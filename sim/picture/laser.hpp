// The range finder's fan as pictures show it: what it meets now. Private to pal_sim.
#pragma once

#include <optional>
#include <vector>

#include "sim/picture/painter.hpp"
#include "sim/picture/stage.hpp"

namespace pal::sim {

/// The points that the fan meets, without the errors and the time of a scan.
struct Laser {
  struct Point {
    double across = 0, away = 0;                      // in the fan's plane, mm
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  // in the world, m
  };
  std::vector<Point> points;  // those within 100 to 1000 mm, from one side of the fan to the other

  /// The least `away`; nothing: the fan meets nothing.
  std::optional<double> nearest() const;
};

/// Of a stage whose tool is the range finder.
Laser laser_of(const Stage& stage);

/// The fan and the line that it draws on what it meets.
std::vector<Mark> marks_of(const Laser& laser, const Stage& stage);

}  // namespace pal::sim
