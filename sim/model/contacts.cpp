#include "sim/model/contacts.hpp"

#include <algorithm>
#include <array>

namespace pal::sim {
namespace {

double normal_force(const Physics& physics, int contact) {
  std::array<mjtNum, 6> force{};
  mj_contactForce(&physics.model(), &physics.data(), contact, force.data());
  return force[0];
}

Role role(const Physics& physics, int geom) {
  return physics.index().roles[static_cast<std::size_t>(geom)];
}

bool is_collision(const Physics& physics, const mjContact& contact) {
  const Role one = role(physics, contact.geom1), other = role(physics, contact.geom2);
  if (one == Role::cell && other == Role::cell) return false;
  // The fingers may close on each other.
  if (one == Role::touch) return other == Role::arm;
  if (other == Role::touch) return one == Role::arm;
  return true;
}

bool loose(const Physics& physics, int geom) {
  const mjModel& model = physics.model();
  const int joint = model.body_jntadr[model.geom_bodyid[geom]];
  return joint >= 0 && model.jnt_type[joint] == mjJNT_FREE;
}

// Whether a pad meets something the way that the fingers close, and not with an edge from above.
bool closes_on(const Physics& physics, const mjContact& contact, int pad) {
  constexpr double half_a_right_angle = 0.7;  // the cosine
  const mjtNum* turn = physics.data().geom_xmat + 9 * static_cast<std::ptrdiff_t>(pad);
  const Eigen::Vector3d closing(turn[1], turn[4], turn[7]);  // a pad's y axis
  return std::abs(closing.dot(Eigen::Map<const Eigen::Vector3d>(contact.frame))) > half_a_right_angle;
}

// A pad of the gripper that closes on a loose part, or one finger at the other.
bool is_grip(const Physics& physics, const mjContact& contact) {
  if (physics.loaded().tool != ToolKind::gripper) return false;
  for (const FingerIndex& finger : physics.index().fingers) {
    if (contact.geom1 != finger.pad_geom && contact.geom2 != finger.pad_geom) continue;
    const int other = contact.geom1 == finger.pad_geom ? contact.geom2 : contact.geom1;
    if (!closes_on(physics, contact, finger.pad_geom)) continue;
    if (loose(physics, other) || role(physics, other) == Role::touch) return true;
  }
  return false;
}

}  // namespace

double contact_force(const Physics& physics) {
  double sum = 0;
  for (int i = 0; i < physics.data().ncon; ++i) {
    const mjContact& contact = physics.data().contact[i];
    const bool touches =
        role(physics, contact.geom1) == Role::touch || role(physics, contact.geom2) == Role::touch;
    if (touches && !is_grip(physics, contact)) sum += normal_force(physics, i);
  }
  return sum;
}

Grip grip(const Physics& physics) {
  Grip result;
  if (physics.loaded().tool != ToolKind::gripper) return result;
  std::array<int, 2> held{-1, -1};
  std::array<double, 2> force{};
  for (int i = 0; i < physics.data().ncon; ++i) {
    const mjContact& contact = physics.data().contact[i];
    for (std::size_t side = 0; side < held.size(); ++side) {
      const int pad = physics.index().fingers[side].pad_geom;
      if (contact.geom1 != pad && contact.geom2 != pad) continue;
      if (!closes_on(physics, contact, pad)) continue;
      const int other = contact.geom1 == pad ? contact.geom2 : contact.geom1;
      force[side] += normal_force(physics, i);
      if (loose(physics, other)) held[side] = physics.model().geom_bodyid[other];
    }
  }
  return {force[0], force[1], held[0] >= 0 && held[0] == held[1]};
}

std::optional<Collision> hardest_contact(const Physics& physics) {
  std::optional<Collision> found;
  double most = 20;
  for (int i = 0; i < physics.data().ncon; ++i) {
    const mjContact& contact = physics.data().contact[i];
    const bool one = role(physics, contact.geom1) == Role::cell,
               other = role(physics, contact.geom2) == Role::cell;
    const double force = normal_force(physics, i);
    if (one == other || force <= most) continue;
    most = force;
    found.emplace(contact.geom1, contact.geom2);
  }
  return found;
}

std::optional<Collision> CollisionWatch::look(const Physics& physics) {
  std::optional<Collision> found;
  std::vector<Collision> still;
  for (int i = 0; i < physics.data().ncon; ++i) {
    const mjContact& contact = physics.data().contact[i];
    if (!is_collision(physics, contact)) continue;
    const Collision pair{contact.geom1, contact.geom2};
    if (std::find(forgiven_.begin(), forgiven_.end(), pair) != forgiven_.end())
      still.push_back(pair);
    else if (!found)
      found = pair;
  }
  forgiven_ = std::move(still);
  return found;
}

void CollisionWatch::forgive(const Physics& physics) {
  forgiven_.clear();
  for (int i = 0; i < physics.data().ncon; ++i)
    if (is_collision(physics, physics.data().contact[i]))
      forgiven_.emplace_back(physics.data().contact[i].geom1, physics.data().contact[i].geom2);
}

std::optional<Eigen::Vector3d> place_of(const Physics& physics, const Collision& pair) {
  for (int i = 0; i < physics.data().ncon; ++i) {
    const mjContact& contact = physics.data().contact[i];
    if (Collision{contact.geom1, contact.geom2} != pair) continue;
    return physics.base_pose().inverse() * Eigen::Map<const Eigen::Vector3d>(contact.pos);
  }
  return std::nullopt;
}

std::optional<Collision> overlapping_part(const Physics& physics) {
  constexpr double touching = 0.5e-3;  // m; a part that lies on something may be sunk into it by rounding
  for (int i = 0; i < physics.data().ncon; ++i) {
    const mjContact& contact = physics.data().contact[i];
    if (contact.dist > -touching) continue;
    // Of two parts the one that stands later in the scene.
    if (loose(physics, contact.geom2)) return Collision{contact.geom2, contact.geom1};
    if (loose(physics, contact.geom1)) return Collision{contact.geom1, contact.geom2};
  }
  return std::nullopt;
}

std::optional<Collision> any_contact_of_arm(const Physics& physics) {
  for (int i = 0; i < physics.data().ncon; ++i) {
    const mjContact& contact = physics.data().contact[i];
    if (role(physics, contact.geom1) != Role::cell || role(physics, contact.geom2) != Role::cell)
      return Collision{contact.geom1, contact.geom2};
  }
  return std::nullopt;
}

}  // namespace pal::sim
