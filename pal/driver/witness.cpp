#include "pal/driver/witness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "analyzer/machine.hpp"
#include "analyzer/replay/check_run.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/duration_text.hpp"

namespace pal::driver {
namespace {

using analyzer::rules::FiledWitness;

/// What both a skill and an environment say, so that a witness of others is noticed; nothing if there are no
/// such.
std::string identity_of(const Session& session, const std::string& skill, const std::string& environment) {
  std::ostringstream text;
  for (const pan::Network& network : session.specification.skills) {
    if (network.skill.name == skill) pan::dump(network, text);
  }
  for (const pan::Environment& each : session.specification.environments) {
    if (each.name == environment) pan::dump(each, text);
  }
  return text.str().empty() ? std::string() : analyzer::rules::identity(text.str());
}

FiledWitness filed(const Proof& proof, const analyzer::Verdict& verdict, const Session& session) {
  const analyzer::Witness& witness = *verdict.witness;
  FiledWitness made;
  made.skill = proof.problem.skill;
  made.environment = proof.problem.environment;
  made.identity = identity_of(session, made.skill, made.environment);
  made.requirement = verdict.requirement;
  made.measure = analyzer::name(verdict.measure);
  made.failed = witness.failed;
  made.grows = witness.grows;
  made.value = witness.measured.value;
  made.born = witness.measured.born;
  made.at = witness.measured.at;
  const analyzer::Watch nothing;
  const analyzer::Machine machine(proof.problem, nothing);
  for (const analyzer::ScriptedFiring& firing : witness.script) {
    made.script.push_back(
        {firing.at, firing.timer < 0 ? "" : machine.timer_name(firing.timer), firing.choices});
  }
  made.run = witness.trace;
  return made;
}

std::string shown(const FiledWitness& witness) {
  if (witness.measure == "load") return "a run of the skill; a load shows in no finite run";
  if (witness.failed) return "an event without a response";
  if (witness.measure == "loss") return std::to_string(witness.value) + " lost";
  return witness.measure + (witness.grows ? " of more than " : " ") + to_text(Duration(witness.value));
}

}  // namespace

std::vector<FiledWitness> witnesses_of(const std::vector<Proof>& proofs, const Session& session) {
  std::vector<FiledWitness> made;
  for (const Proof& proof : proofs) {
    for (const analyzer::Verdict& verdict : proof.analysis.verdicts) {
      if (verdict.witness) made.push_back(filed(proof, verdict, session));
    }
  }
  return made;
}

std::optional<std::vector<FiledWitness>> read_witness_file(const std::string& path, const Console& console) {
  const auto content = read_text(path, console);
  if (!content) return std::nullopt;
  try {
    std::istringstream in(*content);
    return analyzer::rules::read_witnesses(in);
  } catch (const std::runtime_error& error) {
    console.err << fmt::format("pal: '{}' has no witnesses: {}\n", path, error.what());
    return std::nullopt;
  }
}

std::string refusal(const FiledWitness& witness, Session& session) {
  if (identity_of(session, witness.skill, witness.environment) != witness.identity) {
    return "it is a run of other texts than these";
  }
  for (const pan::Network& skill : session.specification.skills) {
    for (const pan::Environment& environment : session.specification.environments) {
      if (skill.skill.name != witness.skill || environment.name != witness.environment) continue;
      const auto problem = analyzer::make_problem(skill, environment, session.diagnostics, &session.sources);
      if (!problem) return "the texts have errors";
      const auto requirement =
          std::find_if(problem->requirements.begin(), problem->requirements.end(),
                       [&](const auto& each) { return each.name == witness.requirement; });
      if (requirement == problem->requirements.end()) return "there is no such requirement";
      const analyzer::rules::Ruling ruling = analyzer::rules::check_run(
          *problem, &*requirement, witness.run, witness.grows ? std::optional(witness.at) : std::nullopt);
      if (!ruling.broken.empty()) return ruling.broken;
      if (requirement->measure == analyzer::Requirement::Measure::load) return {};
      if (witness.failed) return ruling.failed ? "" : "every event in it has its response";
      if (witness.grows) {
        const bool longer = ruling.growing_since && witness.at - *ruling.growing_since >= witness.value;
        return longer ? "" : "nothing in it has grown to " + to_text(Duration(witness.value));
      }
      const bool shown = std::any_of(ruling.measured.begin(), ruling.measured.end(), [&](const auto& each) {
        return each.value == witness.value && each.born == witness.born && each.at == witness.at;
      });
      return shown ? "" : "it does not show " + to_text(Duration(witness.value));
    }
  }
  return "there is no such skill, or no such environment";
}

bool confirm(const std::vector<FiledWitness>& witnesses, Session& session, std::ostream& out) {
  bool all = true;
  for (const FiledWitness& witness : witnesses) {
    const std::string why = refusal(witness, session);
    all = all && why.empty();
    out << fmt::format("{:9}  {} of {} in {}: {}\n", why.empty() ? "confirmed" : "refused",
                       witness.requirement, witness.skill, witness.environment,
                       why.empty() ? shown(witness) : why);
  }
  return all;
}

}  // namespace pal::driver
