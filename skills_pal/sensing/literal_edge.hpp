// The edge as the thesis finds it (appendix C.1): a mask over differences, then the slope between two points.
#pragma once

#include <optional>

#include "skills_pal/sensing/profile.hpp"

namespace pal::skills::sensing {

struct LiteralEdge {
  double y = 0;      // mm, of the last point of the nearer surface
  double z = 0;      // mm
  double slope = 0;  // of that surface, deg
};

struct LiteralEdgeOptions {
  /// The sum of seven differences across a point that counts as a step, mm. A surface that leans s has about
  /// 31 mm · s at 200 mm.
  double threshold = 10;
  /// The slope is taken between the points so far from the step, or the last valid ones before.
  std::size_t near_point = 10;
  std::size_t far_point = 60;
};

/// The first step, or nothing if there is none. Only steps are found, no creases. Three defects of the
/// program in the thesis are left out: the nearest of 26 points as the edge, validity the wrong way round, an
/// answer without an edge.
std::optional<LiteralEdge> find_literal_edge(const Profile& profile, const LiteralEdgeOptions& options = {});

}  // namespace pal::skills::sensing
