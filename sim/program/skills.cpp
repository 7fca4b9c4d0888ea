#include "sim/program/skills.hpp"

namespace pal::workcell {

std::vector<KnownSkill> linked_skills() { return {}; }

}  // namespace pal::workcell
