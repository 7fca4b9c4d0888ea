#include "programs/pal/commands/operation_files.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace pal::program {
namespace {

/// Warnings of skills that the operation does not run are left to the check of those skills.
void forget_other_skills(const std::set<std::string>& used, Session& session) {
  std::set<FileId> others, ours;
  for (const pan::Network& network : session.specification.skills)
    (used.contains(network.skill.name) ? ours : others).insert(network.skill.where.file);
  Diagnostics kept;
  for (const Diagnostic& finding : session.diagnostics.all()) {
    const FileId file = finding.where.file;
    if (finding.severity == Severity::warning && others.contains(file) && !ours.contains(file)) continue;
    kept.report(finding);
  }
  session.diagnostics = std::move(kept);
}

/// An environment that lies in a folder of skills, or that the one asked for uses, is not asked for.
void forget_other_environments(const OperationOptions& options, const Console& console, Session& session) {
  std::set<std::string> asked_for;
  for (const std::string& path : options.environments) {
    for (const std::string& file : console.files.list(path, ".pal").value_or(std::vector{path}))
      asked_for.insert(console.files.identity(file));
  }
  std::erase_if(session.specification.environments, [&](const pan::Environment& environment) {
    return !asked_for.contains(console.files.identity(session.sources.name(environment.where.file)));
  });
}

}  // namespace

operations::Skills read_skills(const OperationOptions& options, const std::set<std::string>& used,
                               const Console& console, Session& session,
                               const BuiltSkills& built) {
  Selection selection;
  selection.max_errors = options.max_errors;
  selection.environments = options.environments;
  for (const std::string& path : options.skills) {
    if (const auto found = console.files.list(path, ".pal")) {
      selection.files.insert(selection.files.end(), found->begin(), found->end());
    } else {
      selection.files.push_back(path);
    }
  }
  read(selection, console, session);
  std::erase_if(session.specification.skills,
                [&](const pan::Network& network) { return built.take_the_place_of(network, session); });
  operations::Skills skills;
  for (const pan::Network& network : session.specification.skills)
    skills.emplace(network.skill.name, network.skill);
  if (session.diagnostics.not_kept().sum() == 0) forget_other_skills(used, session);
  std::erase_if(session.specification.skills,
                [&](const pan::Network& network) { return !used.contains(network.skill.name); });
  forget_other_environments(options, console, session);
  return skills;
}

}  // namespace pal::program
