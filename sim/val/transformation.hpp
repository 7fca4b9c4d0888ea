// Locations as VAL writes them: millimetres, and the angles O, A and T in degrees.
#pragma once

#include <array>
#include <string>

#include "sim/arm/kinematics.hpp"

namespace pal::sim::val {

/// X Y Z O A T.
using Figures = std::array<double, 6>;

/// The rotation is Rz(O) M Ry(A) Rz(T), where M has the rows (0 1 0), (0 0 -1), (-1 0 0): with all angles 0
/// the tool points along -y. (90, -90, 0) is the identity.
Pose pose_of(const Figures& figures);

/// A within -90 and 90; where it is one of them, O and T turn about one line, and T is 0. `upright`: so near
/// (rad) counts.
Figures figures_of(const Pose& pose, double upright = 1e-9);

/// As VAL shows them: a tool that stands upright within 0.01 degrees has T = 0. Below that, the last counts
/// of the encoders would decide on O and T.
Figures shown_figures(const Pose& pose);

/// The joint angles that VAL shows, degrees: those of docs/workcell/model.md plus (0, 180, 180, 0, 0, 0).
/// They are within the ranges of the machine's own manual (joint 2: -225 to 45, joint 3: -45 to 225).
Figures val_joints(const Joints& q);
/// The angles that VAL shows so.
Joints joints_of(const Figures& shown);

/// Six figures in columns of nine: X Y Z with two decimals, angles with three.
std::string columns(const Figures& figures);
/// The same for joint angles: three decimals.
std::string joint_columns(const Figures& figures);

}  // namespace pal::sim::val
