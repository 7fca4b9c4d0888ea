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
  const auto found =
      std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.path == root; });
  if (found == files.end() || !found->has_skill) return inputs;
  const auto more = chosen.empty() ? check::environments_near(files, root, workspace.top(root)) : chosen;
  inputs.insert(inputs.end(), more.begin(), more.end());
  return inputs;
}

bool is_current(const Analysis& analysis, const Workspace& workspace,
                const std::vector<std::string>& inputs) {
  return !analysis.ended && analysis.inputs == inputs &&
         std::all_of(analysis.revisions.begin(), analysis.revisions.end(),
                     [&](const auto& each) { return workspace.revision(each.first) == each.second; });
}

std::shared_ptr<const Analysis> analyze(const Workspace& workspace, std::vector<std::string> inputs,
                                        const std::function<bool()>& stop) {
  auto made = std::make_shared<Analysis>();
  made->root = inputs.front();
  const auto trees = check::read_sources(workspace, made->sources, inputs, made->diagnostics);
  made->specification = check::check(trees, made->diagnostics, stop);
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

namespace {

/// Calls `visit` with each skill that has something to prove, and its environment.
template <class Visit>
void visit_provable(const Analysis& analysis, const std::function<bool()>& stop, const Visit& visit) {
  if (analysis.diagnostics.has_errors()) return;
  for (std::size_t i = 0; i < analysis.specification.skills.size(); ++i) {
    const auto* environment = analysis.environment(i);
    const auto& skill = analysis.specification.skills[i];
    if (environment != nullptr && !skill.requirements.empty() && !stop()) visit(skill, *environment);
  }
}

}  // namespace

Proofs prove(const Analysis& analysis, const Prover& prover, Depth depth, double seconds,
             const std::function<bool()>& stop, const std::function<void(Proofs)>& told) {
  Proofs proofs;
  std::function<void(SkillProof)> told_of_one;
  if (told) {
    told_of_one = [&](SkillProof now) {
      Proofs all = proofs;
      all.push_back(std::move(now));
      told(std::move(all));
    };
  }
  visit_provable(analysis, stop, [&](const auto& skill, const auto& environment) {
    proofs.push_back(prover.prove(skill, environment, analysis.sources, depth, seconds, stop, told_of_one));
  });
  return proofs;
}

bool is_whole(const Proofs& proofs) {
  return std::all_of(proofs.begin(), proofs.end(), [](const SkillProof& proof) {
    return std::all_of(proof.requirements.begin(), proof.requirements.end(),
                       [](const ProvedRequirement& each) { return each.exact; });
  });
}

AllAdvice advise(const Analysis& analysis, const Prover& prover, double seconds,
                 const std::function<bool()>& stop) {
  AllAdvice advice;
  visit_provable(analysis, stop, [&](const auto& skill, const auto& environment) {
    advice.push_back(prover.advise(skill, environment, analysis.sources, seconds, stop));
  });
  return advice;
}

}  // namespace pal::language_server
