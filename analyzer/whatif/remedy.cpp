#include "analyzer/whatif/remedy.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "analyzer/problem/budgets.hpp"
#include "analyzer/whatif/figures.hpp"
#include "analyzer/whatif/requirement_checker.hpp"
#include "analyzer/whatif/trial.hpp"
#include "pal/pan/times.hpp"

namespace pal::analyzer::whatif {
namespace {

using Is = Verdict::State;

/// So many of those that help are tried in twos, and in threes.
constexpr std::size_t most_in_twos = 10;
constexpr std::size_t most_in_threes = 7;

/// A change helps if it brings things nearer by such a part.
constexpr double helpful = 0.98;

class RemedySearch {
 public:
  RemedySearch(const pan::Network& network, const pan::Environment& environment, const NetworkOf& network_of,
               const Options& options, const RemedyOptions& how)
      : network_(network), environment_(environment), network_of_(network_of), options_(options), how_(how) {}

  Remedies run(const Problem& problem, std::size_t programs) {
    made_.before = verdicts_on(problem, options_, options_.max_states, budget::seconds_of_verdicts);
    if (missed(made_.before, made_.before) == 0) return std::move(made_);
    made_.short_enough = short_enough_times(network_, environment_, made_.before,
                                            within(options_, budget::seconds_of_short_enough));
    for (std::size_t number = 0; number < programs; ++number)
      made_.candidates.push_back({{}, ProgramChangeId(number)});
    for (Changes& changes : candidates_for(problem, environment_))
      made_.candidates.push_back({std::move(changes), {}});
    std::vector<CandidateId> all;
    for (std::size_t c = 0; c < made_.candidates.size(); ++c) all.emplace_back(c);
    for (const CandidateId one : all) attempt({one});
    if (made_.found.empty()) combine(all);
    made_.complete = !stopped();
    if (!made_.found.empty()) made_.nearest.reset();
    return std::move(made_);
  }

 private:
  bool stopped() const { return options_.stop && options_.stop(); }
  bool enough() const { return made_.found.size() >= how_.most_found || stopped(); }

  /// Two changes of one thing are none together.
  bool exclude_each_other(const std::vector<CandidateId>& together) const {
    std::set<std::pair<Change::Kind, std::string>> changed;
    for (const CandidateId id : together) {
      for (const Change& change : made_.candidates[id.index()].changes) {
        const bool is_new = change.kind == Change::Kind::new_processor;
        if (!is_new && !changed.emplace(change.kind, change.of).second) return true;
      }
    }
    return false;
  }

  /// The environment with the changes; nothing: one cannot be made.
  std::optional<pan::Environment> environment_with(const std::vector<CandidateId>& together) const {
    pan::Environment environment = environment_;
    std::set<std::string> done;
    for (const CandidateId id : together) {
      for (const Change& each : made_.candidates[id.index()].changes) {
        const std::string made = text(each);
        // Two threads may share a processor that is added.
        if (done.insert(made).second && !change(environment, made).empty()) return std::nullopt;
      }
    }
    return environment;
  }

  const pan::Network* network_with(const std::vector<CandidateId>& together) const {
    std::vector<ProgramChangeId> programs;
    for (const CandidateId id : together) {
      if (made_.candidates[id.index()].program.valid())
        programs.push_back(made_.candidates[id.index()].program);
    }
    return programs.empty() ? &network_ : network_of_(programs);
  }

  std::optional<Problem> problem_with(const std::vector<CandidateId>& together, const pan::Network* network) {
    const auto environment = environment_with(together);
    if (network == nullptr || !environment) return std::nullopt;
    Diagnostics ignored;
    auto problem = make_problem(*network, *environment, ignored);
    if (problem && problem->requirements.size() != made_.before.size()) return std::nullopt;
    return problem;
  }

  RequirementChecker& judge_of(const pan::Network& network) {
    auto& checker = judges_[&network];
    if (!checker) checker = std::make_unique<RequirementChecker>(network, options_);
    return *checker;
  }

  /// Keeps the changes if everything holds with them.
  void attempt(const std::vector<CandidateId>& together) {
    if (enough()) return;
    const pan::Network* network = network_with(together);
    const auto problem = problem_with(together, network);
    if (!problem) return;
    ++made_.tried;
    const Options trial = within(options_, budget::seconds_of_trial);
    const Ruling ruling =
        judge_of(*network).ask(*problem, requirements_of(*problem),
                               {std::min(budget::classes_of_trial, trial.max_states), trial.stop});
    if (ruling.state != Is::holds) return;
    Remedy remedy{together,
                  verdicts_on(*problem, options_, options_.max_states, budget::seconds_of_verdicts)};
    if (missed(remedy.after, made_.before) == 0) made_.found.push_back(std::move(remedy));
  }

  struct Helper {
    CandidateId id;
    double score = 0;
  };

  /// Whether something that holds as things are does not hold any more.
  bool breaks(const std::vector<Verdict>& after) const {
    for (std::size_t r = 0; r < after.size(); ++r) {
      if (made_.before[r].state == Is::holds && after[r].state != Is::holds) return true;
    }
    return false;
  }

  /// Those that bring things nearer, the best first. The best one that breaks nothing is kept as the nearest.
  std::vector<Helper> helpers(const std::vector<CandidateId>& all) {
    const double as_it_is = missed(made_.before, made_.before);
    std::vector<Helper> helping;
    double nearest = as_it_is;
    for (const CandidateId id : all) {
      if (stopped()) break;
      const auto problem = problem_with({id}, network_with({id}));
      if (!problem) continue;
      std::vector<Verdict> after =
          verdicts_on(*problem, options_, budget::classes_of_trial, budget::seconds_of_trial);
      const double score = missed(after, made_.before);
      if (score >= as_it_is * helpful) continue;
      if (score == 0) {
        // A whole analysis decides more than the quick trial did.
        if (!enough()) made_.found.push_back({{id}, std::move(after)});
        continue;
      }
      if (score < nearest && !breaks(after)) {
        nearest = score;
        made_.nearest = Remedy{{id}, std::move(after)};
      }
      helping.push_back({id, score});
    }
    std::stable_sort(helping.begin(), helping.end(),
                     [](const Helper& a, const Helper& b) { return a.score < b.score; });
    return helping;
  }

  void combine(const std::vector<CandidateId>& all) {
    const std::vector<Helper> best = helpers(all);
    if (!made_.found.empty() || how_.most_changes < 2) return;
    const std::size_t twos = std::min(best.size(), most_in_twos);
    for (std::size_t a = 0; a < twos; ++a) {
      for (std::size_t b = a + 1; b < twos; ++b) attempt_together({best[a].id, best[b].id});
    }
    if (!made_.found.empty() || how_.most_changes < 3) return;
    const std::size_t threes = std::min(best.size(), most_in_threes);
    for (std::size_t a = 0; a < threes; ++a) {
      for (std::size_t b = a + 1; b < threes; ++b) {
        for (std::size_t c = b + 1; c < threes; ++c) attempt_together({best[a].id, best[b].id, best[c].id});
      }
    }
  }

  void attempt_together(const std::vector<CandidateId>& together) {
    if (!exclude_each_other(together)) attempt(together);
  }

  const pan::Network& network_;
  const pan::Environment& environment_;
  const NetworkOf& network_of_;
  const Options& options_;
  const RemedyOptions& how_;
  std::map<const pan::Network*, std::unique_ptr<RequirementChecker>> judges_;
  Remedies made_;
};

}  // namespace

Remedies find_remedies(const pan::Network& network, const pan::Environment& environment, std::size_t programs,
                       const NetworkOf& network_of, const Options& options, const RemedyOptions& how) {
  assert(programs == 0 || network_of);
  Diagnostics ignored;
  const pan::Environment whole = pan::with_times_of(network, environment);
  const auto problem = make_problem(network, whole, ignored);
  if (!problem) return {};
  return RemedySearch(network, whole, network_of, options, how).run(*problem, programs);
}

}  // namespace pal::analyzer::whatif
