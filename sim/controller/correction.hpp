// A relative motion, as ALTER takes it.
#pragma once

#include "sim/arm/kinematics.hpp"

namespace pal::sim {

/// Millimetres and degrees; in the frame of the joints all six are degrees of joints 1 to 6. The rotation is
/// about x first, then y, then z, each in the unturned frame.
struct Correction {
  double dx = 0, dy = 0, dz = 0;
  double rx = 0, ry = 0, rz = 0;

  friend bool operator==(const Correction&, const Correction&) = default;
};

/// What a correction is relative to.
enum class CorrectionFrame {
  tool,          // the tool's frame as the corrections so far have turned it
  tool_at_open,  // the tool's frame as it was when ALTER was opened, as the real controller does
  world,         // frame 0, about the tool's tip
  joints,        // the joints, each by its own angle
};

/// The pose that `correction` makes of `pose`; not for the frame of the joints. `opened` is the pose at which
/// ALTER was opened (for tool_at_open).
Pose corrected(const Pose& pose, const Correction& correction, CorrectionFrame frame, const Pose& opened);

}  // namespace pal::sim
