#include "programs/workcell/session/skills.hpp"

#include "skills_pal/longest.hpp"
#include "skills_pal/registry.hpp"

namespace pal::workcell {

std::vector<KnownSkill> linked_skills() {
  std::vector<KnownSkill> known;
  for (const skills::RegisteredSkill& skill : skills::registered_skills()) {
    known.push_back({std::string(skill.name), skill.make, std::string(skill.pal_file),
                     std::string(skill.environment_file)});
    for (const skills::LongestTime& each : skills::longest_times())
      if (each.skill == skill.name) known.back().longest.emplace(each.code, each.seconds);
  }
  return known;
}

}  // namespace pal::workcell
