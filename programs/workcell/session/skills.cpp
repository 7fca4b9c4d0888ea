#include "programs/workcell/session/skills.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <variant>

#include "pal/runtime/plugin.hpp"
#include "programs/workcell/session/failure.hpp"

namespace pal::workcell {

namespace {

namespace fs = std::filesystem;

KnownSkill known(const runtime::SkillPlugin& plugin) {
  auto texts = std::make_shared<MemoryFileSystem>();
  std::vector<std::string> names;
  for (const runtime::SourceText& source : plugin.sources) {
    names.emplace_back(source.name);
    texts->add(names.back(), std::string(source.text));
  }
  operations::Declared declared;
  if (!plugin.declared_file.empty()) {
    const std::string file(plugin.declared_file);
    auto read = operations::read_declared(std::get<std::string>(texts->read(file)));
    if (const auto* wrong = std::get_if<operations::DeclaredError>(&read))
      throw Failure(ExitStatus::wrong_specification, fmt::format("{}:{}", file, wrong->line), wrong->cause,
                    "build the skill again");
    declared = std::get<operations::Declared>(std::move(read));
  }
  return {std::string(plugin.name),
          plugin.make,
          std::string(plugin.pal_file),
          std::string(plugin.environment_file),
          std::move(texts),
          std::move(names),
          std::string(plugin.declared_file),
          std::move(declared),
          {}};
}

std::vector<KnownSkill> skills_of_folder(const std::string& folder) {
  std::vector<KnownSkill> result;
  try {
    for (const runtime::SkillPlugin* plugin : runtime::load_plugins(folder)) result.push_back(known(*plugin));
  } catch (const runtime::PluginError& problem) {
    throw Failure(ExitStatus::usage, folder, problem.what(), problem.hint());
  }
  return result;
}

const runtime::SkillPlugin& load(const std::string& path) {
  try {
    return runtime::load_plugin(path);
  } catch (const runtime::PluginError& problem) {
    throw Failure(ExitStatus::usage, path, problem.what(), problem.hint());
  }
}

}  // namespace

std::vector<KnownSkill> installed_skills() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path installed = program.parent_path().parent_path() / PAL_PLUGIN_FOLDER;
  return skills_of_folder(fs::is_directory(installed, none) ? installed.string()
                                                            : PAL_BUILD_FOLDER "/" PAL_PLUGIN_FOLDER);
}

KnownSkill skill_of_file(const std::string& path) {
  return known(load(path));
}

void add_skills(std::vector<KnownSkill>& skills, const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    std::error_code ignored;
    std::vector<KnownSkill> more;
    if (fs::is_directory(path, ignored)) {
      more = skills_of_folder(path);
      if (more.empty())
        throw Failure(ExitStatus::usage, path, "the folder has no skills",
                      "a skill is a file that ends in .so");
    } else {
      more.push_back(skill_of_file(path));
    }
    for (KnownSkill& skill : more) {
      skill.from = path;
      std::erase_if(skills, [&](const KnownSkill& each) { return each.name == skill.name; });
      skills.push_back(std::move(skill));
    }
  }
  std::sort(skills.begin(), skills.end(),
            [](const KnownSkill& a, const KnownSkill& b) { return a.name < b.name; });
}

std::vector<std::string> changed_texts(const std::string& path) {
  const runtime::SkillPlugin& plugin = load(path);
  std::vector<std::string> changed;
  if (plugin.folder.empty()) return changed;
  const DiskFileSystem disk;
  for (const runtime::SourceText& source : plugin.sources) {
    const auto now = disk.read((fs::path(plugin.folder) / source.name).string());
    const std::string* text = std::get_if<std::string>(&now);
    if (text != nullptr && *text != source.text) changed.emplace_back(source.name);
  }
  return changed;
}

}  // namespace pal::workcell
