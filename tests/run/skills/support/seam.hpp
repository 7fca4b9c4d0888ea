// The seam of sim/scenes/seam.scene in figures, and how far the tool is from where it should be above it.
#pragma once

#include <Eigen/Geometry>

#include "sim/workcell.hpp"

namespace pal::test {

/// With the settings that the scene leaves out; mm in frame 0.
class Seam {
 public:
  Seam();
  Eigen::Vector3d edge(double x) const;
  /// Unit vector.
  Eigen::Vector3d along(double x) const;
  /// Out of the surface on the side of greater y, which is the tool's smaller y; unit vector.
  Eigen::Vector3d normal(double x) const;

 private:
  double highest_ = -1e9;
};

struct OffSeam {
  double length = 0;  // mm, of the edge from where it should be, in the tool's y-z plane
  double turn = 0;    // deg
};

/// `standoff` in mm.
OffSeam off(const Seam& seam, const sim::Sample& sample, double standoff);

}  // namespace pal::test
