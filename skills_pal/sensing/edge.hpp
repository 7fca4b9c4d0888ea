// Logical sensor edge-slope: where an edge is in a profile, and how the surface beside it leans.
#pragma once

#include <optional>

#include "skills_pal/sensing/line.hpp"

namespace pal::skills::sensing {

enum class EdgeKind {
  crease,  // two surfaces meet: the edge is where their lines do
  step,    // one surface ends before another: the edge is the end of the nearer one
};

struct Edge {
  EdgeKind kind = EdgeKind::crease;
  double y = 0;  // mm along the tool's y axis
  double z = 0;  // mm from the range finder
  Line left;     // the surface on the side of smaller y
  Line right;
  std::size_t index = 0;  // the last point of the profile to the left of the edge

  /// The nearer surface of a step; of a crease the one to the left.
  const Line& beside() const;
};

struct EdgeOptions {
  /// An edge is looked for in this many points on either side. It is at least `least_side` points away from
  /// the ends.
  std::size_t window = 20;
  std::size_t least_side = 8;
  /// Lines go on beyond the window as long as points lie on them, up to this many points.
  std::size_t longest_side = 60;
  /// What counts as an edge: the angle between the two surfaces, or the height of the step.
  double least_angle = 5;  // deg
  double least_step = 1;   // mm
  /// Of several edges the one that is nearest to this y (mm); not given: the clearest.
  std::optional<double> expected;
};

/// The edge, or nothing if there is none. Two lines are fitted to the points on either side of each place. An
/// edge is where two lines explain the points clearly better than one does.
std::optional<Edge> find_edge(const Profile& profile, const EdgeOptions& options = {});

}  // namespace pal::skills::sensing
