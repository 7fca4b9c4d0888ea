// What the controller knows of the joints: counts of encoders on the motors, behind gears that have play.
#pragma once

#include <array>

#include "sim/arm/machine.hpp"
#include "sim/arm/puma.hpp"

namespace pal::sim {

/// Counts of each joint's encoder, per radian of the joint: 1000 counts a motor's turn (joint 2: 800) times
/// the gear ratio. Sources: Corke, "The Unimation Puma servo system", 1993 (lines, ratios); the same figures
/// were measured on a machine (S. Graves, comp.robotics, October 1990: 173.92, 239.59, 149.18, 211.21, 199.79
/// and 213.02 counts a degree).
inline constexpr std::array<double, joint_count> encoder_counts{9964.9,  13727.4, 8547.6,
                                                                12101.6, 11446.9, 12205.1};

/// Play of each joint's gears, rad. Our choice, not a published figure: with it, and with the encoders'
/// counts, the arm repeats a pose within the 0.1 mm that Unimation states (docs/workcell/model.md, "Counts
/// and play").
inline constexpr std::array<double, joint_count> gear_play{0.6e-4, 0.6e-4, 0.6e-4, 1.5e-4, 1.5e-4, 1.5e-4};

/// The encoders sit on the motors: they read the joint's angle plus where the motor lies in the gears' play.
class JointSensing {
 public:
  explicit JointSensing(const MachineOptions& options);

  /// A millisecond under these drive torques: the motor moves to the side of the play from which it pushes.
  void advance(const Joints& torques);

  /// The joint angles that the encoders show when the joints stand at `joints`.
  Joints read(const Joints& joints) const;

  /// The angle that can be shown which is nearest to `wanted`: a servo cannot aim between two counts.
  Joints nearest(const Joints& wanted) const;

 private:
  MachineOptions options_;
  Joints play_ = Joints::Zero();    // motor before joint, rad
  Joints origin_ = Joints::Zero();  // where the counts begin, parts of a count
};

}  // namespace pal::sim
