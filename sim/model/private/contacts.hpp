// What touches what, as of the last step. Private to pal_sim.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/model/private/physics.hpp"

namespace pal::sim {

/// Sum of the normal forces on what the tool is made to touch with, N.
double contact_force(const Physics& physics);

/// How hard the two finger pads press on what is between them, N, and whether that is one loose part.
struct Grip {
  double left = 0;
  double right = 0;
  bool part = false;
};
Grip grip(const Physics& physics);

/// A pair of shapes of which one is of the arm and was not made to touch the other.
using Collision = std::pair<int, int>;

/// Finds collisions. Those that were there when it was told to forgive stay forgiven until they have parted,
/// so that an arm can be moved away from what it hit.
class CollisionWatch {
 public:
  std::optional<Collision> look(const Physics& physics);
  void forgive(const Physics& physics);

 private:
  std::vector<Collision> forgiven_;
};

/// Any contact of the arm at all, the tool included: what a start may not have.
std::optional<Collision> any_contact_of_arm(const Physics& physics);

}  // namespace pal::sim
