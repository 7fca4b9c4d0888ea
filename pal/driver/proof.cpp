#include "pal/driver/proof.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "pal/check/resources.hpp"
#include "pal/driver/interruption.hpp"
#include "pal/driver/memory.hpp"
#include "pal/support/duration_text.hpp"

namespace pal::driver {
namespace {

using Measure = analyzer::Requirement::Measure;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// The distinct statements that a requirement is about: "TXM( motion to MC1 ) in SM1".
std::string statements_text(const analyzer::Problem& problem, const analyzer::Requirement& requirement) {
  std::set<std::string> texts;
  for (std::size_t step = 0; step < requirement.at.size(); ++step) {
    if (!requirement.at[step] || problem.steps[step].statement < 0) continue;
    const auto& statement = problem.statements[static_cast<std::size_t>(problem.steps[step].statement)];
    texts.insert(statement.text + " in " + statement.module);
  }
  std::string result;
  for (const std::string& text : texts) result += (result.empty() ? "" : " and ") + text;
  return result;
}

}  // namespace

analyzer::Options options_of(const ProofLimits& limits) {
  const auto begin = Clock::now();
  analyzer::Options options;
  options.max_states = limits.max_states;
  options.threads = limits.threads;
  options.clock = [begin] { return seconds_since(begin); };
  if (limits.peak_memory) options.peak_memory = peak_memory;
  options.stop = [begin, seconds = limits.seconds] {
    return Interruption::asked_for() || (seconds > 0 && seconds_since(begin) > seconds);
  };
  return options;
}

std::vector<Proof> prove(Session& session, const ProofLimits& limits) {
  const Interruption interruption;
  const analyzer::Options options = options_of(limits);
  std::vector<Proof> proofs;
  for (const pan::Network& skill : session.specification.skills) {
    for (const pan::Environment& environment : session.specification.environments) {
      frontend::check_listed(skill, environment, session.diagnostics);
      auto problem = analyzer::make_problem(skill, environment, session.diagnostics, &session.sources);
      if (!problem) continue;
      analyzer::Analysis analysis = analyzer::analyze(*problem, limits.analysis, options);
      const bool explored =
          limits.analysis != analyzer::AnalysisChoice::compositional && analyzer::fits_exploration(*problem);
      proofs.push_back({std::move(*problem), std::move(analysis), explored});
    }
  }
  return proofs;
}

namespace {

std::string known_text(const analyzer::Problem& problem, const analyzer::Requirement& requirement) {
  if (requirement.samples.empty()) return problem.conditions[static_cast<std::size_t>(requirement.condition)];
  return problem.channels[static_cast<std::size_t>(requirement.samples.front())].message + " from " +
         problem.devices[static_cast<std::size_t>(requirement.device)].name;
}

std::string processor_text(const analyzer::Problem& problem, const analyzer::Requirement& requirement) {
  if (requirement.processors.size() != 1) return "each processor";
  return problem.processors[static_cast<std::size_t>(requirement.processors.front())].name;
}

}  // namespace

std::string measure_text(const Proof& proof, std::size_t index) {
  const analyzer::Problem& problem = proof.problem;
  const analyzer::Requirement& requirement = problem.requirements[index];
  switch (requirement.measure) {
    case Measure::age:
      return "age of " + known_text(problem, requirement) + " at " + statements_text(problem, requirement);
    case Measure::reaction:
      return "reaction of " + known_text(problem, requirement) + " at " +
             statements_text(problem, requirement);
    case Measure::response:
      return "response from " + problem.channels[static_cast<std::size_t>(requirement.event)].message +
             " of " + problem.devices[static_cast<std::size_t>(requirement.device)].name + " to " +
             statements_text(problem, requirement);
    case Measure::interval:
      return std::string(requirement.at_least ? "least" : "greatest") + " interval of " +
             statements_text(problem, requirement);
    case Measure::loss:
      return "loss of " + problem.devices[static_cast<std::size_t>(requirement.device)].name +
             (requirement.in == 1 ? "" : " in " + std::to_string(requirement.in));
    case Measure::duration:
      return "duration to completion " + std::to_string(requirement.code);
    case Measure::busy:
      return "busy period of " + processor_text(problem, requirement);
    case Measure::load:
      break;
  }
  return "load of " + processor_text(problem, requirement);
}

std::string figure_text(Measure measure, Duration value) {
  if (measure == Measure::loss) return value.count() == 0 ? "none" : std::to_string(value.count());
  if (measure != Measure::load) return to_text(value);
  const auto hundredths = (value.count() + 99'999) / 100'000;  // 1e9 ns in a second are 100.00 %
  const std::string fraction = std::to_string(hundredths % 100);
  return std::to_string(hundredths / 100) +
         (hundredths % 100 == 0 ? "" : (fraction.size() < 2 ? ".0" : ".") + fraction) + " %";
}

bool all_hold(const std::vector<Proof>& proofs) {
  return std::all_of(proofs.begin(), proofs.end(), [](const Proof& proof) {
    return std::all_of(
        proof.analysis.verdicts.begin(), proof.analysis.verdicts.end(),
        [](const analyzer::Verdict& verdict) { return verdict.state == analyzer::VerdictState::holds; });
  });
}

}  // namespace pal::driver
