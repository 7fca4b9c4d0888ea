// The skills that the workcell can run: those installed with it, and files of skills that a user names.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "operations/declared.hpp"
#include "pal/runtime/skill.hpp"
#include "pal/support/file_system.hpp"

namespace pal::workcell {

struct KnownSkill {
  std::string name;
  std::function<std::unique_ptr<runtime::Skill>()> make;
  std::string pal_file{};  // in `texts`; empty: nothing is proved of it
  std::string environment_file{};
  std::shared_ptr<const MemoryFileSystem> texts{};  // what it was generated from
  std::vector<std::string> text_names{};            // of all of them
  std::string declared_file{};                      // in `texts`; empty: it declares nothing
  operations::Declared declared{};
  std::string from{};  // the file or folder of --skills; empty: it is installed
};

/// Sorted by name. Throws Failure if one cannot be loaded.
std::vector<KnownSkill> installed_skills();

/// Asked by commands that need skills, and by no others: a stop gets through whatever lies in the folder.
using SkillSource = std::function<std::vector<KnownSkill>()>;

/// The skill of a file NAME.so. Throws Failure.
KnownSkill skill_of_file(const std::string& path);

/// Adds the skills of `paths`, files or folders of files; one that is known already gives way. Throws
/// Failure.
void add_skills(std::vector<KnownSkill>& skills, const std::vector<std::string>& paths);

/// The texts that are others on the disk by now, where the skill was built: what runs is what was built.
std::vector<std::string> changed_texts(const std::string& path);

}  // namespace pal::workcell
