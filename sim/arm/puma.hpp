// The PUMA 560 in numbers: kinematics, limits, drives. Metres, radians, newton-metres, kilograms.
//
// Sources: P. I. Corke, Robotics Toolbox (kinematics, drives); Armstrong, Khatib and Burdick 1986 (inertias);
// Corke 1996 (friction, torque limits). Standard Denavit-Hartenberg convention; frame 0 stands where the axes
// of joints 1 and 2 meet. Masses and inertias stand in the model itself (sim/scenes/puma560.xml).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <numbers>

namespace pal::sim {

inline constexpr std::size_t joint_count = 6;

/// Joint angles (or speeds, or torques) of the arm, in the order of the joints.
using Joints = Eigen::Matrix<double, 6, 1>;

inline constexpr double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}
inline constexpr double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

/// One link: rotation q about z, then d along z, a along the new x, alpha about it.
struct Link {
  double alpha;
  double a;
  double d;
};

inline constexpr std::array<Link, joint_count> puma_links{{{radians(90), 0, 0},
                                                           {0, 0.4318, 0},
                                                           {radians(-90), 0.0203, 0.15005},
                                                           {radians(90), 0, 0.4318},
                                                           {radians(-90), 0, 0},
                                                           {0, 0, 0}}};

/// From the wrist's centre (frame 6) to the face of the flange, along z.
inline constexpr double wrist_to_flange = 0.05625;

/// From the flange to the tool's tip, along z: force-torque sensor 35 mm, tool 60 mm.
inline constexpr double flange_to_tip = 0.095;

struct JointLimits {
  double lower;
  double upper;
  double speed;   // rad/s
  double torque;  // N*m at the joint
};

inline constexpr std::array<JointLimits, joint_count> puma_limits{
    {{radians(-160), radians(160), 1.92, 97.6},
     {radians(-45), radians(225), 1.51, 186.4},
     {radians(-225), radians(45), 2.40, 89.4},
     {radians(-110), radians(170), 5.34, 24.2},
     {radians(-100), radians(100), 5.09, 20.1},
     {radians(-266), radians(266), 5.74, 21.3}}};

/// Greatest speed along a straight line, m/s.
inline constexpr double straight_line_speed = 0.5;

}  // namespace pal::sim
