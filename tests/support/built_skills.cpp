#include "tests/support/built_skills.hpp"

#include <stdexcept>
#include <string>

namespace pal::test {

const std::vector<const runtime::SkillPlugin*>& built_skills() {
  static const auto plugins = runtime::load_plugins(PAL_PLUGIN_FOLDER);
  return plugins;
}

const runtime::SkillPlugin& built_skill(std::string_view name) {
  for (const runtime::SkillPlugin* plugin : built_skills())
    if (plugin->name == name) return *plugin;
  throw std::runtime_error("there is no skill " + std::string(name) + " in " PAL_PLUGIN_FOLDER);
}

std::unique_ptr<runtime::Skill> make_skill(std::string_view name) {
  return built_skill(name).make();
}

}  // namespace pal::test
