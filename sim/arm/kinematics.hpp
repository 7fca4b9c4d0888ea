// The poses of the PUMA 560's wrist and tool, and the joint angles for a pose.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/arm/puma.hpp"

namespace pal::sim {

using Pose = Eigen::Isometry3d;

/// Which of the up to eight sets of joint angles is meant, in the words of VAL.
/// Righty: the arm stands as a human's right arm would (wrist in front of the shoulder, q2 rising lifts it).
/// Above: the elbow is above the line from shoulder to wrist. Flip: q5 is negative.
struct Configuration {
  bool righty = true;
  bool above = true;
  bool flip = false;

  friend bool operator==(const Configuration&, const Configuration&) = default;
};

/// "righty above flip".
std::string to_string(Configuration configuration);

/// Reads what to_string writes: three words in any order. Nothing if a word is unknown, missing or given
/// twice.
std::optional<Configuration> parse_configuration(std::string_view text);

/// Frame 6 (the wrist's centre) in frame 0 (the shoulder), by the Denavit-Hartenberg formula.
Pose wrist_pose(const Joints& q);

/// The face of the flange in frame 0; z points out of it.
Pose flange_pose(const Joints& q);

/// The tip in frame 0 of a tool that stands at `tool` in the flange's frame; z points out of the tool.
Pose tool_pose(const Joints& q, const Pose& tool);

/// The same for the pad, whose tip is 95 mm before the flange.
Pose tool_pose(const Joints& q);

/// The configuration in which joint angles `q` hold the arm.
Configuration configuration_of(const Joints& q);

enum class InverseProblem {
  none,
  too_far,     // beyond the stretched arm
  too_near,    // inside the folded arm, or on the axis of joint 1
  over_limit,  // a joint would have to leave its range
};

struct InverseSolution {
  Joints q = Joints::Zero();
  InverseProblem problem = InverseProblem::none;
  std::size_t joint = 0;  // the first joint over its limit, if problem is over_limit
};

/// The joint angles that bring the wrist's centre to `wrist` in `configuration`. Full turns are chosen so
/// that each joint is within its limits and then as near as can be to `reference`. Where joints 4 and 6 are
/// in line
/// (|sin q5| < 1e-9) joint 4 stays at its reference. `q` is also given when the problem is over_limit.
InverseSolution inverse_wrist(const Pose& wrist, Configuration configuration, const Joints& reference);

/// The same for the tip of a tool that stands at `tool` in the flange's frame.
InverseSolution inverse_tool(const Pose& tip, const Pose& tool, Configuration configuration,
                             const Joints& reference);

/// The same on a path that goes on from joint angles `from`: no joint turns by more than half a turn. A joint
/// that would come there only by a turn back through the rest of its range is over its limit.
InverseSolution next_on_path(const Pose& tip, const Pose& tool, Configuration configuration,
                             const Joints& from);

/// The same as inverse_tool above, for the pad.
InverseSolution inverse_tool(const Pose& tip, Configuration configuration, const Joints& reference);

/// From the flange to the pad's tip.
Pose pad_tool();

}  // namespace pal::sim
