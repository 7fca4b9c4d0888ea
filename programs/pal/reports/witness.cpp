#include "programs/pal/reports/witness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "analyzer/machine/machine.hpp"
#include "analyzer/run_checker/check_run.hpp"
#include "analyzer/runs/quick_runs.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/duration_text.hpp"

namespace pal::program {
namespace {

using analyzer::run_checker::FiledWitness;

/// What both a skill and an environment say, so that a witness of others is noticed.
std::string identity_of(const pan::Network& skill, const pan::Environment& environment) {
  std::ostringstream text;
  pan::dump(skill, text);
  pan::dump(environment, text);
  return analyzer::run_checker::identity(text.str());
}

FiledWitness filed(const analyzer::Problem& problem, const std::string& requirement,
                   analyzer::Requirement::Measure measure, const analyzer::Witness& witness) {
  FiledWitness made;
  made.skill = problem.skill;
  made.environment = problem.environment;
  made.requirement = requirement;
  made.measure = analyzer::name(measure);
  made.failed = witness.failed;
  made.grows = witness.grows;
  made.value = witness.measured.value;
  made.born = witness.measured.born;
  made.at = witness.measured.at;
  const analyzer::Watch nothing;
  const analyzer::Machine machine(problem, nothing);
  for (const analyzer::ScriptedFiring& firing : witness.script) {
    if (firing.timer == machine.pause_timer()) continue;  // of what is measured, not of the run
    made.script.push_back(
        {firing.at, firing.timer < 0 ? "" : machine.timer_name(firing.timer), firing.choices});
  }
  made.run = witness.trace;
  return made;
}

/// An environment with fewer processors gets new ones up to this number (pal whatif --place).
constexpr std::size_t most_processors = 100;

bool has_processors(const pan::Environment& environment, const FiledWitness& witness) {
  const std::size_t all = std::max(environment.processors.size(), most_processors);
  return std::all_of(witness.placement.begin(), witness.placement.end(),
                     [all](const auto& each) { return static_cast<std::size_t>(each.processor) < all; });
}

/// The environment in which the witness has its threads.
pan::Environment placed(const pan::Environment& environment, const FiledWitness& witness) {
  if (witness.placement.empty()) return environment;
  std::vector<analyzer::whatif::ThreadPlacement> threads;
  for (const auto& each : witness.placement)
    threads.push_back(
        {each.thread, analyzer::ProcessorId(static_cast<std::size_t>(each.processor)), each.priority});
  return analyzer::whatif::placed(environment, threads);
}

/// Why the run does not show what the witness claims of `requirement`; empty: it does.
std::string refusal(const FiledWitness& witness, const analyzer::Problem& problem,
                    const analyzer::Requirement& requirement) {
  const analyzer::run_checker::Ruling ruling = analyzer::run_checker::check_run(
      problem, &requirement, witness.run, witness.grows ? std::optional(witness.at) : std::nullopt);
  if (!ruling.broken.empty()) return ruling.broken;
  if (witness.measure != analyzer::name(requirement.measure))
    return "the requirement measures something else";
  if (witness.value < 0 && !witness.failed) return "no value is below 0";
  if (requirement.measure == analyzer::Requirement::Measure::load) return {};
  if (witness.failed) return ruling.failed ? "" : "every event in it has its response";
  if (witness.grows) {
    const bool grown = ruling.growing_since && *ruling.growing_since <= witness.born &&
                       witness.at - witness.born == witness.value;
    return grown ? "" : "nothing in it has grown to " + to_text(Duration(witness.value));
  }
  const bool is_shown = std::any_of(ruling.measured.begin(), ruling.measured.end(), [&](const auto& each) {
    return each.value == witness.value && each.born == witness.born && each.at == witness.at;
  });
  return is_shown ? "" : "it does not show " + to_text(Duration(witness.value));
}

/// A run that breaks the one requirement of `problem`. Most are found as they were when it was refuted.
std::optional<analyzer::Witness> breaking(const analyzer::Problem& problem,
                                          const analyzer::Options& options) {
  auto simulated = analyzer::simulated_witness(problem, problem.requirements.front(), options.stop,
                                               analyzer::events_for(options.max_states));
  if (simulated) return simulated;
  auto analysis = analyzer::analyze(problem, analyzer::AnalysisChoice::automatic, options);
  analyzer::Verdict& verdict = analysis.verdicts.front();
  return verdict.state == analyzer::VerdictState::fails ? std::move(verdict.witness) : std::nullopt;
}

std::string placement_text(const FiledWitness& witness) {
  std::string text;
  for (const auto& each : witness.placement)
    text += fmt::format("{}{} on processor {} with priority {}", text.empty() ? ", " : "; ", each.thread,
                        each.processor + 1, each.priority);
  return text;
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
      if (!verdict.witness) continue;
      made.push_back(filed(proof.problem, verdict.requirement, verdict.measure, *verdict.witness));
      for (const pan::Network& skill : session.specification.skills) {
        for (const pan::Environment& environment : session.specification.environments) {
          if (skill.skill.name == proof.problem.skill && environment.name == proof.problem.environment)
            made.back().identity = identity_of(skill, environment);
        }
      }
    }
  }
  return made;
}

std::vector<std::string> filed_witnesses_of(const std::vector<analyzer::whatif::Placements>& placements,
                                            const pan::Network& network, const pan::Environment& environment,
                                            const analyzer::Options& options) {
  std::vector<std::string> made;
  for (const analyzer::whatif::Placements& on : placements) {
    for (const analyzer::whatif::Placed& refuted : on.refuted) {
      if (options.stop && options.stop()) return made;
      const pan::Environment there = analyzer::whatif::placed(environment, refuted.threads);
      Diagnostics known;
      auto problem = analyzer::make_problem(network, there, known);
      if (!problem) continue;
      problem->requirements = {problem->requirements[refuted.ruling.requirement.index()]};
      const auto witness = breaking(*problem, options);
      if (!witness) continue;
      const analyzer::Requirement& requirement = problem->requirements.front();
      FiledWitness found = filed(*problem, requirement.name, requirement.measure, *witness);
      found.identity = identity_of(network, there);
      for (const analyzer::whatif::ThreadPlacement& each : refuted.threads)
        found.placement.push_back({each.thread, each.processor.value, each.priority});
      made.push_back(analyzer::run_checker::filed_text(found));
    }
  }
  return made;
}

std::optional<std::vector<FiledWitness>> read_witness_file(const std::string& path, const Console& console) {
  const auto content = read_runs(path, console);
  if (!content) return std::nullopt;
  try {
    std::istringstream in(*content);
    return analyzer::run_checker::read_witnesses(in);
  } catch (const std::runtime_error& error) {
    console.err << fmt::format("pal: '{}' is no file of witnesses: {}\n", path, error.what());
    return std::nullopt;
  }
}

std::string refusal(const FiledWitness& witness, Session& session) {
  for (const pan::Network& skill : session.specification.skills) {
    for (const pan::Environment& each : session.specification.environments) {
      if (skill.skill.name != witness.skill || each.name != witness.environment) continue;
      if (!has_processors(each, witness)) return "a thread is on a processor that does not exist";
      const pan::Environment environment = placed(each, witness);
      if (identity_of(skill, environment) != witness.identity)
        return "it is a run of another version of these files";
      const auto problem = analyzer::make_problem(skill, environment, session.diagnostics, &session.sources);
      if (!problem) return "the texts have errors";
      for (const auto& requirement : problem->requirements) {
        if (requirement.name == witness.requirement) return refusal(witness, *problem, requirement);
      }
      return "there is no such requirement";
    }
  }
  return "there is no such skill, or no such environment";
}

bool confirm(const std::vector<FiledWitness>& witnesses, Session& session, std::ostream& out) {
  bool all = true;
  if (witnesses.empty()) out << "nothing to confirm: the file has no run\n";
  for (const FiledWitness& witness : witnesses) {
    const std::string why = refusal(witness, session);
    all = all && why.empty();
    out << fmt::format("{:9}  {} of {} in {}{}: {}\n", why.empty() ? "confirmed" : "refused",
                       witness.requirement, witness.skill, witness.environment, placement_text(witness),
                       why.empty() ? shown(witness) : why);
  }
  return all;
}

}  // namespace pal::program
