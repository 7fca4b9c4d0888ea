#include "tests/run/skills/support/proved_bounds.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <variant>

#include "pal/support/file_system.hpp"
#include "programs/pal/reports/proof_chart.hpp"
#include "tests/support/built_skills.hpp"

namespace pal::test {

namespace {

/// The disk, with a workcell.pal that is slower.
class SlowerDisk final : public DiskFileSystem {
 public:
  explicit SlowerDisk(const std::optional<Slower>& slower) : slower_(slower) {}

  std::variant<std::string, FileError> read(const std::string& path, std::size_t most) const override {
    auto text = DiskFileSystem::read(path, most);
    if (slower_ && path.ends_with("/workcell.pal"))
      std::get<0>(text) = slow_down(std::get<0>(text), *slower_);
    return text;
  }

 private:
  std::optional<Slower> slower_;
};

/// The disk, with a skill that is written in another way.
class RewrittenDisk final : public DiskFileSystem {
 public:
  RewrittenDisk(std::string pal_file, Rewritten rewritten)
      : pal_file_(std::move(pal_file)), rewritten_(std::move(rewritten)) {}

  std::variant<std::string, FileError> read(const std::string& path, std::size_t most) const override {
    auto text = DiskFileSystem::read(path, most);
    if (!path.ends_with(pal_file_)) return text;
    std::string& pal = std::get<0>(text);
    const std::size_t at = pal.find(rewritten_.from);
    if (at == std::string::npos) throw std::runtime_error(path + " has no " + rewritten_.from);
    pal.replace(at, rewritten_.from.size(), rewritten_.to);
    return text;
  }

 private:
  std::string pal_file_;
  Rewritten rewritten_;
};

program::Proof prove(const std::string& name, const FileSystem& files, std::size_t most_states) {
  const runtime::SkillPlugin& skill = built_skill(name);
  const std::string folder = PAL_SOURCE_DIR "/";
  std::ostringstream out, err;
  program::Session session;
  program::Selection selection;
  selection.files = {folder + std::string(skill.pal_file)};
  selection.environments = {folder + std::string(skill.environment_file)};
  if (!program::read(selection, {out, err, files}, session))
    throw std::runtime_error(name + ": " + err.str());
  auto proofs = program::prove(session, {.max_states = most_states});
  if (proofs.size() != 1) throw std::runtime_error(name + " is not one skill in one workcell");
  return std::move(proofs.front());
}

}  // namespace

ProvedBounds::ProvedBounds(const std::string& skill, const std::optional<Slower>& slower,
                           std::size_t most_states)
    : proof_(prove(skill, SlowerDisk(slower), most_states)) {}

ProvedBounds::ProvedBounds(const std::string& skill, const Rewritten& rewritten)
    : proof_(prove(skill, RewrittenDisk(std::string(built_skill(skill).pal_file), rewritten),
                   program::ProofLimits{}.max_states)) {}

void ProvedBounds::observe(const trace::Trace& run) {
  alter_.count(run);
  for (std::size_t i = 0; i < proof_.analysis.verdicts.size(); ++i) {
    const analyzer::Verdict& verdict = proof_.analysis.verdicts[i];
    if (!verdict.bound || !program::shows_in_runs(proof_.problem.requirements[i])) continue;
    const auto longest = program::longest_in(run, proof_, i);
    if (!longest) continue;
    Worst& worst = worst_[verdict.requirement];
    worst.bound = *verdict.bound;
    worst.observed = std::max(worst.observed, Duration(longest->length_ns()));
  }
}

double ProvedBounds::greatest_part() const {
  double greatest = 0;
  for (const auto& [requirement, worst] : worst_) greatest = std::max(greatest, worst.part());
  return greatest;
}

bool ProvedBounds::fails(const std::string& requirement) const {
  return std::any_of(proof_.analysis.verdicts.begin(), proof_.analysis.verdicts.end(),
                     [&](const analyzer::Verdict& verdict) {
                       return verdict.requirement == requirement &&
                              verdict.state == analyzer::Verdict::State::fails;
                     });
}

bool ProvedBounds::all_hold() const {
  return std::all_of(
      proof_.analysis.verdicts.begin(), proof_.analysis.verdicts.end(),
      [](const analyzer::Verdict& verdict) { return verdict.state == analyzer::Verdict::State::holds; });
}

}  // namespace pal::test
