// Opens the shared library of a skill, and checks that it was built for this runtime.
#include <dlfcn.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "pal/runtime/plugin.hpp"

namespace pal::runtime {

const SkillPlugin& load_plugin(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    throw PluginError("there is no such file", "check the path");
  // A name without a slash would be looked for among the system's libraries.
  void* library = ::dlopen(std::filesystem::absolute(path).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw PluginError("it cannot be loaded: " + std::string(::dlerror()),
                      "a skill's file is made by pal_add_skill(… WORKCELL)");
  using Function = const SkillPlugin* (*)();
  const auto function = reinterpret_cast<Function>(::dlsym(library, plugin_function));
  if (function == nullptr)
    throw PluginError("it has no skill: there is no function pal_skill in it",
                      "a skill's file is made by pal_add_skill(… WORKCELL)");
  const SkillPlugin* plugin = function();
  if (plugin == nullptr || std::strcmp(plugin->interface, plugin_interface) != 0)
    throw PluginError("it was built for " + std::string(plugin == nullptr ? "nothing" : plugin->interface) +
                          ", and this is " + plugin_interface,
                      "build it again with the installed pal");
  return *plugin;
}

std::vector<const SkillPlugin*> load_plugins(const std::string& folder) {
  std::vector<const SkillPlugin*> plugins;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (entry.path().extension() != ".so") continue;
    try {
      plugins.push_back(&load_plugin(entry.path()));
    } catch (const PluginError& problem) {
      throw PluginError(entry.path().string() + ": " + problem.what(), problem.hint());
    }
  }
  std::sort(plugins.begin(), plugins.end(),
            [](const SkillPlugin* a, const SkillPlugin* b) { return a->name < b->name; });
  return plugins;
}

}  // namespace pal::runtime
