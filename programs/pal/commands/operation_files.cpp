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
    Diagnostic& again = kept.report(finding.code, finding.where, finding.message, finding.hint);
    again.notes = finding.notes;
    again.fix = finding.fix;
  }
  session.diagnostics = std::move(kept);
}

}  // namespace

operations::Skills read_skills(const OperationOptions& options, const std::set<std::string>& used,
                               const Console& console, Session& session) {
  Selection selection;
  selection.max_errors = options.max_errors;
  selection.environments = options.environments;
  for (const std::string& path : options.skills) {
    if (const auto found = console.files.list(path, ".pal")) {
      // An environment in the folder is not the one that was asked for.
      selection.files.insert(selection.files.end(), found->begin(), found->end());
    } else {
      selection.files.push_back(path);
    }
  }
  read(selection, console, session);
  operations::Skills skills;
  for (const pan::Network& network : session.specification.skills)
    skills.emplace(network.skill.name, network.skill);
  if (session.diagnostics.not_kept().sum() == 0) forget_other_skills(used, session);
  std::erase_if(session.specification.skills,
                [&](const pan::Network& network) { return !used.contains(network.skill.name); });
  if (options.environments.empty()) session.specification.environments.clear();
  return skills;
}

}  // namespace pal::program
