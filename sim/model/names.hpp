// The parts of a model, and their names for people. Private to pal_sim.
#pragma once

#include <string>
#include <string_view>

#include "sim/model/mujoco_physics.hpp"

namespace pal::sim {

/// Finds what the workcell needs. Throws SceneError when the scene lacks something.
ModelIndex find_names(const mjModel& model, ToolKind tool, const Scene& scene);

/// Contacts between the outer half of the arm and the inner half are collisions.
void let_arm_meet_itself(mjModel& model, const ModelIndex& index);

/// The name of what a shape belongs to, "post 2"; empty if it has none.
std::string thing_of(const mjModel& model, int geom);

/// "the forearm", "post 2", "the table".
std::string words_for(const mjModel& model, int geom);

/// "the forearm hit post 2"; the arm's part first, of two parts of the arm the one farther out.
std::string contact_words(const mjModel& model, int geom, std::string_view verb, int other);

}  // namespace pal::sim
