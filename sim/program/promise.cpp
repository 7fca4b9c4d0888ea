#include "sim/program/promise.hpp"

#include <filesystem>
#include <sstream>

#include "pal/driver/proof_chart.hpp"
#include "sim/program/failure.hpp"

namespace pal::workcell {
namespace {

std::string in_folders(const std::string& file, const std::vector<std::string>& folders) {
  std::error_code ignored;
  for (const std::string& folder : folders) {
    const std::filesystem::path path = std::filesystem::path(folder) / file;
    if (std::filesystem::exists(path, ignored)) return path.string();
  }
  throw Failure(ExitStatus::usage, file, "the PAL of the skill is not there, so nothing can be proved of it",
                "run with --no-proof, or install the skills beside the program");
}

}  // namespace

std::vector<Promise> promises(const KnownSkill& skill, const std::vector<std::string>& folders,
                              const trace::Trace& run) {
  std::vector<Promise> result;
  if (skill.pal_file.empty()) return result;
  const DiskFileSystem files;
  std::ostringstream out, err;
  driver::Session session;
  driver::Selection selection;
  selection.files = {in_folders(skill.pal_file, folders)};
  selection.environments = {in_folders(skill.environment_file, folders)};
  selection.skill = skill.name;
  const driver::Console console{out, err, files};
  const bool chosen = driver::read(selection, console, session);
  std::vector<driver::Proof> proofs;
  if (chosen && !session.diagnostics.has_errors()) proofs = driver::prove(session, {});
  if (proofs.empty()) {
    driver::show_findings(session, console);
    throw Failure(ExitStatus::wrong_specification, selection.files.front(),
                  "the PAL of the skill is wrong\n" + err.str());
  }
  for (const driver::Proof& proof : proofs) {
    for (std::size_t i = 0; i < proof.analysis.verdicts.size(); ++i) {
      const analyzer::Verdict& verdict = proof.analysis.verdicts[i];
      const analyzer::Requirement& requirement = proof.problem.requirements[i];
      if (!driver::shows_in_runs(requirement) || !verdict.witness || !verdict.bound) continue;
      Promise promise{
          verdict.requirement, driver::measure_text(proof.problem, i), *verdict.bound, verdict.exact, {}, {}};
      if (const auto longest = driver::longest_in(run, proof, i))
        promise.measured = Duration(longest->length_ns());
      promise.chart = driver::overlay_chart(proof, i, run);
      result.push_back(std::move(promise));
    }
  }
  return result;
}

}  // namespace pal::workcell
