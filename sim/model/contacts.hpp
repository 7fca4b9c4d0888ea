// The contacts of the last step. Private to pal_sim.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/model/mujoco_physics.hpp"

namespace pal::sim {

/// Sum of the normal forces on the touching parts of the tool (Role::touch), N. The grip is not among them:
/// what the gripper's pads do to a loose part on which they close, and to one another.
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

/// The contact of the arm with something else that presses hardest, if it presses with more than 20 N.
std::optional<Collision> hardest_contact(const Physics& physics);

/// Finds collisions. Collisions that exist at a call of forgive() do not count until the parts have
/// separated. So an arm can be moved away from what it hit.
class CollisionWatch {
 public:
  std::optional<Collision> look(const Physics& physics);
  void forgive(const Physics& physics);

 private:
  std::vector<Collision> forgiven_;
};

/// Where the pair touches, in frame 0, m.
std::optional<Eigen::Vector3d> place_of(const Physics& physics, const Collision& pair);

/// A loose part and a shape of the cell, part or not, that are in the same place by more than 0.5 mm. The
/// loose part comes first.
std::optional<Collision> overlapping_part(const Physics& physics);

/// Any contact of the arm at all, the tool included; a start must not have any.
std::optional<Collision> any_contact_of_arm(const Physics& physics);

}  // namespace pal::sim
