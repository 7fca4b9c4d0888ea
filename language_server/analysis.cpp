#include "language_server/analysis.hpp"

#include <algorithm>
#include <utility>

#include "pal/check/project.hpp"
#include "pal/check/read_sources.hpp"

namespace pal::language_server {

const pan::Environment* Analysis::environment(std::size_t skill) const {
  const auto index = skill < environment_of.size() ? environment_of[skill] : std::nullopt;
  return index ? &specification.environments[*index] : nullptr;
}

std::vector<std::string> inputs_of(Workspace& workspace, const std::string& root,
                                   const std::vector<std::string>& chosen) {
  std::vector<std::string> inputs{root};
  const auto& files = workspace.project();
  const auto found = std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.path == root; });
  if (found == files.end() || !found->has_skill) return inputs;
  const auto more =
      chosen.empty() ? check::environments_near(files, root, workspace.top(root)) : chosen;
  inputs.insert(inputs.end(), more.begin(), more.end());
  return inputs;
}

bool is_current(const Analysis& analysis, const Workspace& workspace, const std::vector<std::string>& inputs) {
  return !analysis.ended && analysis.inputs == inputs &&
         std::all_of(analysis.revisions.begin(), analysis.revisions.end(), [&](const auto& each) {
           return workspace.revision(each.first) == each.second;
         });
}

std::shared_ptr<const Analysis> analyze(const Workspace& workspace, std::vector<std::string> inputs,
                                        const std::function<bool()>& stop) {
  auto made = std::make_shared<Analysis>();
  made->root = inputs.front();
  made->trees = check::read_sources(workspace, made->sources, inputs, made->diagnostics);
  made->specification = check::check(made->trees, made->diagnostics, stop);
  made->ended = stop && stop();
  made->inputs = std::move(inputs);
  for (const auto& skill : made->specification.skills)
    made->environment_of.push_back(check::fitting_environment(skill, made->specification.environments));
  for (std::size_t i = 0; i < made->sources.size(); ++i) {
    const auto& path = made->sources.name(FileId(i));
    auto text = workspace.text(path);
    made->texts.push_back(text != nullptr ? std::move(text) : std::make_shared<const Text>());
    made->revisions[path] = workspace.revision(path);
  }
  return made;
}

Proofs prove(const Analysis& analysis, const Prover& prover, double seconds,
             const std::function<bool()>& stop) {
  Proofs proofs;
  if (analysis.diagnostics.has_errors()) return proofs;
  for (std::size_t i = 0; i < analysis.specification.skills.size(); ++i) {
    const auto* environment = analysis.environment(i);
    const auto& skill = analysis.specification.skills[i];
    if (environment == nullptr || skill.requirements.empty() || stop()) continue;
    proofs.push_back(prover.prove(skill, *environment, analysis.sources, seconds, stop));
  }
  return proofs;
}

}  // namespace pal::language_server
