#include "programs/pal/session/proof.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "pal/check/resources.hpp"
#include "pal/check/shared_messages.hpp"
#include "programs/pal/session/interruption.hpp"
#include "programs/pal/session/memory.hpp"

namespace pal::program {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

std::optional<analyzer::Problem> problem_of(const pan::Network& skill, const pan::Environment& environment,
                                            Session& session) {
  check::check_listed(skill, environment, session.diagnostics);
  check::check_shared_messages(skill, environment, session.diagnostics);
  return analyzer::make_problem(skill, environment, session.diagnostics, &session.sources);
}

analyzer::Options options_of(const ProofLimits& limits) {
  const auto begin = Clock::now();
  analyzer::Options options;
  options.max_states = limits.max_states;
  options.threads = limits.threads;
  options.addends = limits.addends;
  options.clock = [begin] { return seconds_since(begin); };
  if (limits.peak_memory) options.peak_memory = peak_memory;
  options.stop = end_after(limits.seconds, limits.begun);
  if (limits.seconds > 0) options.deadline = std::max(0.0, limits.seconds - seconds_since(limits.begun));
  return options;
}

std::function<bool()> end_after(double seconds, Clock::time_point begin) {
  return [begin, seconds] {
    return Interruption::asked_for() || (seconds > 0 && seconds_since(begin) > seconds);
  };
}

void limit_checks(const ProofLimits& limits, Session& session) {
  session.stop = end_after(limits.seconds / 2, limits.begun);
}

std::vector<Proof> prove(Session& session, const ProofLimits& limits) {
  const Interruption interruption;
  const analyzer::Options options = options_of(limits);
  std::vector<Proof> proofs;
  for (const pan::Network& skill : session.specification.skills) {
    for (const pan::Environment& environment : session.specification.environments) {
      auto problem = problem_of(skill, environment, session);
      if (!problem) continue;
      analyzer::Analysis analysis = analyzer::analyze(*problem, limits.analysis, options);
      const bool explored =
          limits.analysis != analyzer::AnalysisChoice::compositional && analyzer::fits_exploration(*problem);
      proofs.push_back({std::move(*problem), std::move(analysis), explored, options.stop()});
    }
  }
  return proofs;
}

bool all_hold(const std::vector<Proof>& proofs) {
  return std::all_of(proofs.begin(), proofs.end(), [](const Proof& proof) {
    return std::all_of(
        proof.analysis.verdicts.begin(), proof.analysis.verdicts.end(),
        [](const analyzer::Verdict& verdict) { return verdict.state == analyzer::VerdictState::holds; });
  });
}

}  // namespace pal::program
