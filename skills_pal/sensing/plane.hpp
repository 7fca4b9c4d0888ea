// Logical sensor plane: how a flat surface lies before the tool.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace pal::skills::sensing {

/// A plane in the frame of its points, mostly the tool's: mm and deg.
struct Plane {
  double standoff = 0;  // z where the tool's z axis meets it
  /// What the tool must turn to stand square to the plane: about x, then about y as it was before, as ALTER
  /// takes it.
  double turn_x = 0;
  double turn_y = 0;
  double flatness = 0;  // root mean square of how far the points on it lie off it
  std::size_t points = 0;
};

struct PlaneOptions {
  /// Points this far off do not belong to the plane, mm.
  double thickness = 1;
  /// So many of all points (0 to 1) must belong to it, at least `least_points`.
  double least_share = 0.8;
  std::size_t least_points = 50;
  /// What the points must cover at least in their shorter direction, mm. One profile of a tool that stands
  /// still shows only a line, and planes of any lean contain it.
  double least_width = 5;
};

/// The plane through most of the points, or nothing if they are not flat, too few, or all on one line.
std::optional<Plane> find_plane(std::span<const Eigen::Vector3d> points, const PlaneOptions& options = {});

}  // namespace pal::skills::sensing
