// Logical sensor nearest-point: what is nearest to the range finder in a profile.
#pragma once

#include <optional>

#include "skills_pal/sensing/profile.hpp"

namespace pal::skills::sensing {

struct NearestPoint {
  double y = 0;  // mm along the tool's y axis
  double z = 0;  // mm from the range finder
};

/// The place of least z, or nothing if no surface is in range. A single point that its neighbours contradict
/// is no surface. z is that of a line through the points around it that belong to the same surface. The least
/// of 255 noisy values alone would lie three deviations too near.
std::optional<NearestPoint> find_nearest_point(const Profile& profile);

}  // namespace pal::skills::sensing
