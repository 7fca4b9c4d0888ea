#include "programs/workcell/session/skills.hpp"

#include "skills_pal/registry.hpp"

namespace pal::workcell {

std::vector<KnownSkill> linked_skills() {
  std::vector<KnownSkill> known;
  for (const skills::RegisteredSkill& skill : skills::registered_skills())
    known.push_back({std::string(skill.name), skill.make, std::string(skill.pal_file),
                     std::string(skill.environment_file)});
  return known;
}

}  // namespace pal::workcell
