// The figures of the ALTER line that both of its ends keep (docs/workcell/alter.md).
#pragma once

#include <chrono>

#include "pal/runtime/device.hpp"

namespace pal::runtime::drivers::alter {

/// The period of the controller's cycle. Each cycle begins with a request.
inline constexpr Time period = std::chrono::milliseconds(28);
/// The answer must have arrived this long after its cycle began; the rest is for computing set-points.
inline constexpr Time answer_within = std::chrono::milliseconds(24);

/// The largest figure of a correction, and the steps in which figures are sent (mm or degrees).
inline constexpr double greatest_correction = 32.767;
inline constexpr double resolution = 0.001;

}  // namespace pal::runtime::drivers::alter
