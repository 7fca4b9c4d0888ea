#include "tests/run/skills/support/proved_bounds.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <variant>

#include "pal/driver/proof_chart.hpp"
#include "pal/support/file_system.hpp"
#include "skills_pal/registry.hpp"

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

driver::Proof prove(const std::string& name, const std::optional<Slower>& slower, std::size_t most_states) {
  for (const skills::RegisteredSkill& skill : skills::registered_skills()) {
    if (skill.name != name) continue;
    const std::string folder = PAL_SOURCE_DIR "/skills_pal/";
    const SlowerDisk files(slower);
    std::ostringstream out, err;
    driver::Session session;
    driver::Selection selection;
    selection.files = {folder + std::string(skill.pal_file)};
    selection.environments = {folder + std::string(skill.environment_file)};
    if (!driver::read(selection, {out, err, files}, session))
      throw std::runtime_error(name + ": " + err.str());
    auto proofs = driver::prove(session, {.max_states = most_states});
    if (proofs.size() != 1) throw std::runtime_error(name + " is not one skill in one workcell");
    return std::move(proofs.front());
  }
  throw std::runtime_error("there is no skill " + name);
}

}  // namespace

ProvedBounds::ProvedBounds(const std::string& skill, const std::optional<Slower>& slower,
                           std::size_t most_states)
    : proof_(prove(skill, slower, most_states)) {}

void ProvedBounds::observe(const trace::Trace& run) {
  for (std::size_t i = 0; i < proof_.analysis.verdicts.size(); ++i) {
    const analyzer::Verdict& verdict = proof_.analysis.verdicts[i];
    if (!verdict.bound || !driver::shows_in_runs(proof_.problem.requirements[i])) continue;
    const auto longest = driver::longest_in(run, proof_, i);
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
