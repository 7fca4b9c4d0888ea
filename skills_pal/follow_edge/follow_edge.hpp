// Follow Edge: along an edge in six degrees of freedom.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

/// follow_edge.pal.
std::unique_ptr<runtime::Skill> follow_edge_skill();

}  // namespace pal::skills
