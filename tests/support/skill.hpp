// Skills in tests: from PAL text to the analyzer's model.
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "analyzer/problem/problem.hpp"
#include "pal/check/check.hpp"
#include "pal/check/read_sources.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "pal/support/file_system.hpp"
#include "pal/support/render.hpp"

namespace pal::test {

/// Everything that a problem was made from.
struct Skill {
  SourceManager sources;
  Diagnostics diagnostics;
  check::Specification specification;
  std::optional<analyzer::Problem> problem;
};

inline std::string messages(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& each : diagnostics.all())
    text += std::string(name(each.code)) + " " + each.message + "\n";
  return text;
}

/// The first skill in the first environment. `problem` is empty if something is wrong; the diagnostics say
/// what.
inline std::unique_ptr<Skill> load_skill(const FileSystem& files, const std::vector<std::string>& paths) {
  auto skill = std::make_unique<Skill>();
  const auto trees = check::read_sources(files, skill->sources, paths, skill->diagnostics);
  skill->specification = check::check(trees, skill->diagnostics);
  if (skill->diagnostics.has_errors()) return skill;
  if (skill->specification.skills.empty() || skill->specification.environments.empty()) {
    throw std::runtime_error("no skill, or no environment");
  }
  skill->problem =
      analyzer::make_problem(skill->specification.skills.front(), skill->specification.environments.front(),
                             skill->diagnostics, &skill->sources);
  return skill;
}

inline std::unique_ptr<Skill> skill_from_files(const std::vector<std::string>& paths) {
  return load_skill(DiskFileSystem(), paths);
}

inline std::unique_ptr<Skill> skill_from_text(const std::string& text) {
  MemoryFileSystem files;
  files.add("skill.pal", text);
  return load_skill(files, {"skill.pal"});
}

/// As skill_from_text, for texts that must be right.
inline std::unique_ptr<Skill> sound_skill(const std::string& text) {
  auto skill = skill_from_text(text);
  if (!skill->problem) throw std::runtime_error(messages(skill->diagnostics));
  return skill;
}

}  // namespace pal::test
