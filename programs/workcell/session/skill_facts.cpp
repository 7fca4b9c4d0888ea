#include "programs/workcell/session/skill_facts.hpp"

#include <sys/resource.h>

#include <functional>
#include <memory>
#include <sstream>
#include <variant>

#include "analyzer/analysis.hpp"
#include "programs/pal/session/memory.hpp"
#include "programs/pal/session/proof.hpp"
#include "programs/pal/session/selection.hpp"
#include "programs/workcell/session/needed_tool.hpp"
#include "sim/arm/tool.hpp"

namespace pal::workcell {
namespace {

using server::KnownRequirement;
using Verdict = KnownRequirement::Verdict;

Verdict verdict_of(analyzer::VerdictState state) {
  if (state == analyzer::VerdictState::holds || state == analyzer::VerdictState::never) return Verdict::holds;
  return state == analyzer::VerdictState::fails ? Verdict::fails : Verdict::undecided;
}

bool is_load(const pan::Requirement& requirement) {
  return std::holds_alternative<pan::Load>(requirement.measure);
}

bool is_loss(const pan::Requirement& requirement) {
  return std::holds_alternative<pan::Loss>(requirement.measure);
}

bool is_from_below(const pan::Requirement& requirement) {
  const auto* passes = std::get_if<pan::Passes>(&requirement.measure);
  return passes != nullptr && passes->least && !passes->most;
}

Duration limit_of(const pan::Requirement& requirement) {
  const auto* passes = std::get_if<pan::Passes>(&requirement.measure);
  if (const auto* loss = std::get_if<pan::Loss>(&requirement.measure)) return Duration(loss->most);
  return passes == nullptr ? requirement.limit
         : passes->most    ? *passes->most
                           : passes->least.value_or(Duration{});
}

/// The number of a loss; seconds, or per cent of a load: nanoseconds of work in a second.
double in_unit(const pan::Requirement& requirement, Duration value) {
  if (is_loss(requirement)) return static_cast<double>(value.count());
  const double seconds = static_cast<double>(value.count()) / 1e9;
  return is_load(requirement) ? 100 * seconds : seconds;
}

std::string text_of(const pan::Requirement& requirement, const SourceManager& sources) {
  if (!requirement.where.valid()) return {};
  const auto at = sources.line_column(requirement.where.file, requirement.where.begin);
  std::string text(sources.line_text(requirement.where.file, at.line));
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

/// As read, before anything is proved.
server::SkillFacts facts_of(const pan::Network& network, const std::string& environment,
                            const SourceManager& sources) {
  server::SkillFacts facts;
  facts.skill = network.skill;
  facts.environment = environment;
  for (const pan::Requirement& requirement : network.requirements)
    facts.requirements.push_back({requirement.name, text_of(requirement, sources), Verdict::proving,
                                  std::nullopt, in_unit(requirement, limit_of(requirement)),
                                  is_load(requirement)   ? "%"
                                  : is_loss(requirement) ? ""
                                                         : "s",
                                  is_from_below(requirement)});
  return facts;
}

void note(const pan::Network& network, const analyzer::Analysis& analysis, server::Facts& facts) {
  server::SkillFacts& skill = facts.skills[network.skill.name];
  for (std::size_t i = 0; i < network.requirements.size(); ++i) {
    const pan::Requirement& requirement = network.requirements[i];
    for (const analyzer::Verdict& verdict : analysis.verdicts) {
      if (verdict.requirement != requirement.name) continue;
      KnownRequirement& known = skill.requirements[i];
      known.verdict = verdict_of(verdict.state);
      if (verdict.bound) known.bound = in_unit(requirement, *verdict.bound);
      const auto* completing = std::get_if<pan::Completing>(&requirement.measure);
      if (completing != nullptr && verdict.bound)
        facts.times[{network.skill.name, completing->code}] = *verdict.bound;
    }
  }
}

/// A skill as its PAL has it.
struct Studied {
  program::Session session{};
  pan::Network network{};
  pan::Environment environment{};
};

/// Nothing if the skill names no PAL, or this pal finds it wrong.
std::unique_ptr<Studied> read(const KnownSkill& skill, const std::function<bool()>& stop) {
  if (skill.pal_file.empty()) return nullptr;
  auto studied = std::make_unique<Studied>();
  studied->session.stop = stop;
  std::ostringstream out, error;
  program::Selection selection;
  selection.files = {skill.pal_file};
  selection.environments = {skill.environment_file};
  selection.skill = skill.name;
  const program::Session& session = studied->session;
  if (!program::read(selection, {out, error, *skill.texts}, studied->session) ||
      session.diagnostics.has_errors() || session.specification.skills.empty() ||
      session.specification.environments.empty())
    return nullptr;
  studied->network = session.specification.skills.front();
  studied->environment = session.specification.environments.front();
  return studied;
}

/// Gives the memory that proofs and drawings needed back to the system, which else stays with the program.
struct Trimmed {
  Trimmed() = default;
  ~Trimmed() { program::give_back_memory(); }
  Trimmed(const Trimmed&) = delete;
  Trimmed& operator=(const Trimmed&) = delete;
};

}  // namespace

SkillScholar::SkillScholar(const std::vector<KnownSkill>& known, server::Knowledge& knowledge,
                           const SkillPictures& pictures)
    : thread_([this, &known, &knowledge, &pictures] { study(known, knowledge, pictures); }) {}

SkillScholar::~SkillScholar() {
  ending_ = true;
  if (thread_.joinable()) thread_.join();
}

void SkillScholar::study(const std::vector<KnownSkill>& known, server::Knowledge& knowledge,
                         const SkillPictures& pictures) const {
  // The cell's own threads come first; on Linux this is of the thread. Clients, too, have drawings made,
  // which wait for each other: so a drawing that has begun must not wait long for a processor.
  constexpr int less_urgent = 5, least_urgent = 19;
  ::setpriority(PRIO_PROCESS, 0, less_urgent);
  const Trimmed trimmed;
  auto facts = std::make_shared<server::Facts>();
  std::vector<std::unique_ptr<Studied>> all;
  for (const KnownSkill& each : known) {
    auto studied = read(each, [this] { return ending_.load(); });
    if (ending_) return;
    if (!studied) continue;
    auto& skill = facts->skills[each.name] =
        facts_of(studied->network, studied->environment.name, studied->session.sources);
    if (const auto tool = needed_tool(*each.make())) skill.tool = sim::to_string(*tool);
    all.push_back(std::move(studied));
  }
  knowledge.learn(std::make_shared<server::Facts>(*facts));
  for (const auto& studied : all) {
    if (ending_) return;
    pictures.draw_modules(studied->network, facts->skills[studied->network.skill.name].pictures);
  }
  knowledge.learn(std::make_shared<server::Facts>(*facts));
  ::setpriority(PRIO_PROCESS, 0, least_urgent);
  program::ProofLimits limits;
  limits.threads = 1;
  analyzer::Options options = program::options_of(limits);
  options.stop = [this, usual = options.stop] { return ending_.load() || (usual && usual()); };
  for (const auto& studied : all) {
    if (ending_) return;
    const pan::Network& network = studied->network;
    auto problem = program::problem_of(network, studied->environment, studied->session);
    if (!problem) continue;
    program::Proof proof;
    proof.analysis = analyzer::analyze(*problem, analyzer::AnalysisChoice::automatic, options);
    proof.problem = std::move(*problem);
    note(network, proof.analysis, *facts);
    if (!ending_) pictures.draw_runs(proof, facts->skills[network.skill.name].pictures);
    if (!ending_) knowledge.learn(std::make_shared<server::Facts>(*facts));
  }
}

}  // namespace pal::workcell
