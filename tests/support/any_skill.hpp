// Skills that the checker rightly refuses, and that have a meaning all the same.
#pragma once

#include <algorithm>
#include <map>
#include <string>

#include "tests/support/skill.hpp"

namespace pal::test {

/// As skill_from_text, but some errors are allowed: deadlocks, ends without a completion, conditions that are
/// set twice or never, and requests that two blocks send. What such a skill does is as well defined as that
/// of any other. `refused` counts what else is wrong.
inline std::unique_ptr<Skill> any_skill(const std::string& text,
                                        std::map<std::string, int>* refused = nullptr) {
  static const char* const pass[] = {"PAL0307", "PAL0401", "PAL0402", "PAL0403",
                                     "PAL0504", "PAL0505", "PAL0521", "PAL0522"};
  MemoryFileSystem files;
  files.add("skill.pal", text);
  auto skill = std::make_unique<Skill>();
  const auto trees = check::read_sources(files, skill->sources, {"skill.pal"}, skill->diagnostics);
  skill->specification = check::check(trees, skill->diagnostics);
  for (const Diagnostic& each : skill->diagnostics.all()) {
    const std::string code(name(each.code));
    const bool passes = std::find(std::begin(pass), std::end(pass), code) != std::end(pass);
    if (each.severity != Severity::error || passes) continue;
    if (refused != nullptr) ++(*refused)[code + " " + each.message];
    return skill;
  }
  if (skill->specification.skills.empty() || skill->specification.environments.empty()) return skill;
  Diagnostics diagnostics;
  skill->problem =
      analyzer::make_problem(skill->specification.skills.front(), skill->specification.environments.front(),
                             diagnostics, &skill->sources);
  if (!skill->problem && refused != nullptr) ++(*refused)[messages(diagnostics)];
  return skill;
}

/// As any_skill, for texts that must have a meaning.
inline std::unique_ptr<Skill> meaningful_skill(const std::string& text) {
  auto skill = any_skill(text);
  if (!skill->problem) throw std::runtime_error("no meaning: " + messages(skill->diagnostics));
  return skill;
}

}  // namespace pal::test
