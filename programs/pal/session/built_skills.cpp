#include "programs/pal/session/built_skills.hpp"

#include <algorithm>
#include <utility>

namespace pal::program {
namespace {

bool is_built(const pan::Network& skill, const BuiltSkill& built, const Session& session) {
  return built.name == skill.skill.name && session.sources.name(skill.skill.where.file) == built.pal;
}

}  // namespace

void BuiltSkills::add(std::vector<BuiltSkill> built, std::vector<std::string>& skills,
                      std::vector<std::string>& environments) {
  for (BuiltSkill& each : built) {
    skills.push_back(each.pal);
    environments.push_back(each.environment);
    built_.push_back(std::move(each));
  }
}

bool BuiltSkills::runs_in(const pan::Network& skill, const pan::Environment& environment,
                          const Session& session) const {
  const std::string& file = session.sources.name(environment.where.file);
  const auto its_own = [&](const BuiltSkill& each) { return file == each.environment; };
  const auto it = std::find_if(built_.begin(), built_.end(),
                               [&](const BuiltSkill& each) { return is_built(skill, each, session); });
  return it != built_.end() ? its_own(*it) : std::none_of(built_.begin(), built_.end(), its_own);
}

bool BuiltSkills::take_the_place_of(const pan::Network& skill, const Session& session) const {
  return std::any_of(built_.begin(), built_.end(), [&](const BuiltSkill& each) {
    return each.name == skill.skill.name && !is_built(skill, each, session);
  });
}

const std::string* BuiltSkills::text_of(const std::string& path) const {
  for (const BuiltSkill& skill : built_)
    if (const auto found = skill.texts.find(path); found != skill.texts.end()) return &found->second;
  return nullptr;
}

std::variant<std::string, FileError> BuiltSkills::read(const std::string& path, std::size_t most) const {
  const std::string* text = text_of(path);
  if (text == nullptr) return disk_.read(path, most);
  if (text->size() > most) return FileError{"it is too large"};
  return *text;
}

std::optional<std::vector<std::string>> BuiltSkills::list(const std::string& path,
                                                          std::string_view ending) const {
  return disk_.list(path, ending);
}

std::string BuiltSkills::identity(const std::string& path) const {
  return text_of(path) != nullptr ? path : disk_.identity(path);
}

std::vector<std::string> take_built(std::vector<std::string>& skills) {
  std::vector<std::string> built;
  std::erase_if(skills, [&built](const std::string& path) {
    if (!path.ends_with(".so")) return false;
    built.push_back(path);
    return true;
  });
  return built;
}

}  // namespace pal::program
