#include "programs/pal/session/proof.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "pal/check/resources.hpp"
#include "pal/check/shared_uses.hpp"
#include "programs/pal/session/interruption.hpp"
#include "programs/pal/session/kept_here.hpp"
#include "programs/pal/session/memory.hpp"
#include "programs/pal/session/patience.hpp"

namespace pal::program {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// An analysis in a thread of its own: Ctrl-C is obeyed at once, whatever the analysis is at.
class Attempt : public std::enable_shared_from_this<Attempt> {
 public:
  Attempt(analyzer::Problem problem, analyzer::AnalysisChoice choice, analyzer::Options options)
      : problem_(std::move(problem)), choice_(choice), options_(std::move(options)) {}

  /// After run(); not to be called twice.
  analyzer::Problem problem() {
    const std::lock_guard lock(mutex_);
    if (!ended_) return problem_;  // the analysis still reads it
    return std::move(problem_);
  }

  /// What is known after it has ended, or soon after Ctrl-C. `observer` sees what is known by then.
  analyzer::Analysis run(const ProofObserver& observer) {
    using namespace std::chrono_literals;
    constexpr auto look = 10ms;
    constexpr auto patience = 30ms;
    // Exploring alone says nothing before it ends.
    const auto patience_for_a_first_word =
        choice_ == analyzer::AnalysisChoice::exact ? std::chrono::milliseconds(2s) : patience;
    std::thread([self = shared_from_this()] { self->work(); }).detach();
    std::optional<Clock::time_point> asked;
    std::unique_lock lock(mutex_);
    while (!done_.wait_for(lock, look, [this] { return ended_; })) {
      if (observer && !known_.verdicts.empty() && !Interruption::asked_for()) observer(problem_, known_);
      if (!Interruption::asked_for()) continue;
      if (!asked) asked = Clock::now();
      const bool any =
          std::any_of(known_.verdicts.begin(), known_.verdicts.end(),
                      [](const analyzer::Verdict& verdict) { return verdict.bound.has_value(); });
      const auto waited = Clock::now() - *asked;
      if (waited < patience || known_.verdicts.empty() || (!any && waited < patience_for_a_first_word))
        continue;
      leave_work();
      return known_;
    }
    if (thrown_) std::rethrow_exception(thrown_);
    return std::move(known_);
  }

 private:
  void work() {
    analyzer::Options options = options_;
    options.known = [this](const analyzer::Analysis& analysis) {
      const std::lock_guard lock(mutex_);
      known_ = analysis;
    };
    std::optional<analyzer::Analysis> made;
    std::exception_ptr thrown;
    try {
      made = analyzer::analyze(problem_, choice_, options);
    } catch (...) {
      thrown = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    if (made) known_ = std::move(*made);
    thrown_ = thrown;
    ended_ = true;
    done_.notify_all();
  }

  analyzer::Problem problem_;
  const analyzer::AnalysisChoice choice_;
  const analyzer::Options options_;
  std::mutex mutex_;
  std::condition_variable done_;
  bool ended_ = false;
  analyzer::Analysis known_;
  std::exception_ptr thrown_;
};

}  // namespace

std::optional<analyzer::Problem> problem_of(const pan::Network& skill, const pan::Environment& environment,
                                            const SourceManager& sources, Diagnostics& diagnostics) {
  check::check_listed(skill, environment, diagnostics);
  check::check_shared_uses(skill, environment, diagnostics);
  return analyzer::make_problem(skill, environment, diagnostics, &sources);
}

namespace {

/// The same, given up soon after Ctrl-C: then the session is as it was.
std::optional<analyzer::Problem> problem_in_patience(const pan::Network& skill,
                                                     const pan::Environment& environment, Session& session,
                                                     const std::shared_ptr<const Session>& alive) {
  struct Made {
    std::optional<analyzer::Problem> problem;
    Diagnostics diagnostics;
  };
  const auto made = std::make_shared<Made>();
  const auto build = [made, alive, &skill, &environment, &sources = session.sources] {
    made->problem = problem_of(skill, environment, sources, made->diagnostics);
  };
  if (!done_in_patience(build)) return std::nullopt;
  for (const Diagnostic& finding : made->diagnostics.all()) session.diagnostics.report(finding);
  return std::move(made->problem);
}

}  // namespace

std::optional<analyzer::Problem> problem_of(const pan::Network& skill, const pan::Environment& environment,
                                            Session& session) {
  return problem_of(skill, environment, session.sources, session.diagnostics);
}

analyzer::Options options_of(const ProofLimits& limits) {
  const auto begin = Clock::now();
  analyzer::Options options;
  options.max_states = limits.max_states;
  options.threads = limits.threads;
  options.addends = limits.addends;
  options.clock = [begin] { return seconds_since(begin); };
  if (limits.peak_memory) options.peak_memory = peak_memory;
  const std::size_t memory = limits.max_memory > 0 ? limits.max_memory : memory_there_is() / 2;
  options.stop = [end = end_after(limits.seconds, limits.begun), memory] {
    return end() || takes_more(memory);
  };
  if (limits.seconds > 0) options.deadline = std::max(0.0, limits.seconds - seconds_since(limits.begun));
  return options;
}

std::shared_ptr<std::atomic<bool>> note_stop(analyzer::Options& options) {
  const auto limited = std::make_shared<std::atomic<bool>>(false);
  options.stop = [stop = options.stop, limited] {
    const bool now = stop();
    if (now) *limited = true;
    return now;
  };
  return limited;
}

std::function<bool()> end_after(double seconds, Clock::time_point begin) {
  return [begin, seconds] {
    return Interruption::asked_for() || (seconds > 0 && seconds_since(begin) > seconds);
  };
}

void limit_checks(const ProofLimits& limits, Session& session) {
  session.stop = end_after(limits.seconds / 2, limits.begun);
}

bool is_of(const pan::Network& skill, const pan::Environment& environment,
           const check::Specification& specification) {
  const auto seen = specification.seen.find(skill.skill.where.file);
  const auto sees = [&](const pan::Environment& other) {
    return seen != specification.seen.end() && seen->second.contains(other.where.file);
  };
  return sees(environment) ||
         std::none_of(
             specification.environments.begin(), specification.environments.end(),
             [&](const pan::Environment& other) { return other.name == environment.name && sees(other); });
}

namespace {

/// Of a skill, if another one has its name.
std::string file_of(const pan::Network& skill, const Session& session) {
  const auto same =
      std::count_if(session.specification.skills.begin(), session.specification.skills.end(),
                    [&](const pan::Network& other) { return other.skill.name == skill.skill.name; });
  if (same < 2 || !skill.skill.where.valid()) return {};
  return session.sources.name(skill.skill.where.file);
}

}  // namespace

std::vector<Proof> prove(Session& session, const ProofLimits& limits, const ProofObserver& observer,
                         const std::shared_ptr<const Session>& alive) {
  const Interruption interruption;
  analyzer::Options options = options_of(limits);
  const auto limited = note_stop(options);
  std::vector<Proof> proofs;
  for (const pan::Network& skill : session.specification.skills) {
    for (const pan::Environment& environment : session.specification.environments) {
      if (!is_of(skill, environment, session.specification)) continue;
      if (limits.leaves_out && limits.leaves_out(skill, environment)) continue;
      if (is_work_left()) return proofs;
      auto problem = alive ? problem_in_patience(skill, environment, session, alive)
                           : problem_of(skill, environment, session);
      if (!problem) continue;
      KeptHere kept(skill, environment, session, limits);
      if (auto analysis = kept.find(*problem)) {
        proofs.push_back({std::move(*problem), std::move(*analysis), true, false, false,
                          file_of(skill, session), false, true});
        continue;
      }
      const bool explored = limits.analysis != analyzer::AnalysisChoice::compositional &&
                            limits.analysis != analyzer::AnalysisChoice::half_open &&
                            analyzer::fits_exploration(*problem);
      if (Interruption::asked_for()) {
        analyzer::Analysis none = analyzer::nothing_known(*problem, "The proof had not begun.");
        proofs.push_back(
            {std::move(*problem), std::move(none), explored, true, true, file_of(skill, session), false});
        continue;
      }
      *limited = false;
      const auto attempt = std::make_shared<Attempt>(std::move(*problem), limits.analysis, options);
      analyzer::Analysis analysis = attempt->run(observer);
      proofs.push_back({attempt->problem(), std::move(analysis), explored, (options.stop() || is_work_left()),
                        Interruption::asked_for(), file_of(skill, session),
                        limits.analysis == analyzer::AnalysisChoice::half_open});
      if (!*limited && !proofs.back().ended) kept.keep(proofs.back().analysis);
    }
  }
  return proofs;
}

std::string heading_of(const Proof& proof) {
  return proof.problem.skill + " in " + proof.problem.environment +
         (proof.file.empty() ? "" : " (" + proof.file + ")");
}

bool all_hold(const std::vector<Proof>& proofs) {
  return std::all_of(proofs.begin(), proofs.end(), [](const Proof& proof) {
    return std::all_of(
        proof.analysis.verdicts.begin(), proof.analysis.verdicts.end(),
        [](const analyzer::Verdict& verdict) { return verdict.state == analyzer::VerdictState::holds; });
  });
}

}  // namespace pal::program
