// Profiles of shapes that are known exactly, with the range finder's rays, steps and errors.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <random>
#include <vector>

#include "skills_pal/sensing/profile.hpp"

namespace pal::skills::sensing::test {

/// A corner of an outline in the plane of the fan, mm.
struct Corner {
  double y = 0;
  double z = 0;
};

/// A chain of straight pieces.
using Outline = std::vector<Corner>;

struct Scan {
  std::array<double, most_points> y{};
  std::array<double, most_points> z{};
  std::array<bool, most_points> valid{};

  Profile profile() const { return {y, z, valid}; }
};

/// The stated error at a distance, mm: 0.1 below 150, 0.2 at 250, 2 at 850, 20 at 1000.
double stated_error(double z);

/// How far a ray in the fan goes in z at this angle (rad); negative: it meets nothing.
using Shape = std::function<double(double angle)>;

Shape outline(Outline corners);
/// The plane `normal` · p = `distance` (mm) from a pose of the range finder.
Shape plane(const Eigen::Vector3d& normal, double distance, const Eigen::Isometry3d& pose);

/// The profile of a shape. `errors` scales the errors. Points out of range are invalid. So are points on a
/// surface that is met more steeply than 75 degrees, except after a single jump to a nearer point.
Scan scan(const Shape& shape, std::mt19937& random, double errors = 1);

}  // namespace pal::skills::sensing::test
