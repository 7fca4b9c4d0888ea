// How a tool stands square on a surface, from three places on it.
#pragma once

#include <optional>

#include "server/scene.hpp"

namespace pal::server {

/// A frame at `origin`. Its z axis is square to the plane of the three places, on the side of the z axis of
/// `origin`. Its x axis leads to `along`. `beside` is anywhere else on the plane. Nothing, if two of them are
/// closer than 5 mm, or all three lie within ten degrees of a line.
std::optional<ScenePose> surface_frame(const ScenePose& origin, const ScenePose& along,
                                       const ScenePose& beside);

}  // namespace pal::server
