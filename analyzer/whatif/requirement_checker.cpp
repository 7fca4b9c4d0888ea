#include "analyzer/whatif/requirement_checker.hpp"

#include <algorithm>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/exact/zeno_run.hpp"
#include "analyzer/problem/budgets.hpp"

namespace pal::analyzer::whatif {
namespace {

using Is = Verdict::State;

/// They cost next to nothing, and often suffice.
std::vector<Verdict> bounds_of(const Problem& problem, const RequirementIds& requirements, Options options) {
  Problem asked = problem;
  asked.requirements.clear();
  for (const RequirementId r : requirements) asked.requirements.push_back(problem.requirements[r.index()]);
  options.addends = false;
  return compositional::analyze(asked, options).verdicts;
}

}  // namespace

struct RequirementChecker::Progress {
  RequirementIds order;
  std::vector<Decision> decisions;    // by order
  std::vector<std::size_t> explored;  // by order: classes

  /// The first that is shown to fail.
  std::optional<std::size_t> failing() const {
    const auto found = std::find_if(decisions.begin(), decisions.end(),
                                    [](const Decision& each) { return each.state == Is::fails; });
    return found == decisions.end() ? std::nullopt : std::optional<std::size_t>(found - decisions.begin());
  }
};

std::optional<Problem> RequirementChecker::problem(const pan::Environment& environment) const {
  Diagnostics ignored;
  return make_problem(network_, environment, ignored);
}

RequirementId RequirementChecker::refuted(const Problem& problem, const RequirementIds& requirements,
                                          const std::function<bool()>& stop) {
  for (const auto& known : refutations_->runs()) {
    if (stop && stop()) return {};
    const RequirementId r = known->requirement;
    const bool asked = std::find(requirements.begin(), requirements.end(), r) != requirements.end();
    if (asked && refutes(problem, r, known->witness, stop)) return r;
  }
  return {};
}

bool RequirementChecker::bounded(const Problem& problem, const RequirementIds& requirements) const {
  const std::vector<Verdict> bounds = bounds_of(problem, requirements, options_);
  return std::all_of(bounds.begin(), bounds.end(),
                     [](const Verdict& bound) { return bound.state == Is::holds; });
}

bool RequirementChecker::has_zeno_run(const Problem& problem) {
  return find_zeno_run(problem, {options_.max_states, options_.stop, {}, &workers_}).found.has_value();
}

Ruling RequirementChecker::ruling_of(const Problem& problem, Progress progress, const Effort& effort) {
  const auto failing = progress.failing();
  Ruling ruling{failing ? Is::fails : Is::holds, {}, {}};
  bool known = true;
  for (std::size_t k = 0; k < progress.order.size(); ++k) {
    const Decision& decision = progress.decisions[k];
    const bool says = failing ? k == *failing : decision.state == Is::undecided;
    if (says && !ruling.requirement.valid()) {
      ruling.state = decision.state;
      ruling.requirement = progress.order[k];
    }
    if (decision.excess) ruling.excess = std::max(ruling.excess.value_or(*decision.excess), *decision.excess);
    known = known && decision.excess;
    if (failing && k == *failing) break;
  }
  if (!known) ruling.excess.reset();
  // Where time stands still nothing holds, and what has no end by then is not measured.
  const bool of_all_time = ruling.state == Is::holds || (failing && progress.decisions[*failing].grows);
  if (of_all_time) {
    const ZenoSearch look = find_zeno_run(problem, {options_.max_states, effort.stop, {}, &workers_});
    if (look.found || (!look.excluded && effort.over()))
      return {Is::undecided, progress.order.empty() ? RequirementId() : progress.order.front(), {}};
  }
  if (failing)
    refutations_->remember(progress.order[*failing], std::move(progress.decisions[*failing].witness));
  return ruling;
}

Ruling RequirementChecker::ask(const Problem& problem, const RequirementIds& requirements,
                               const Effort& effort) {
  if (const RequirementId broken = refuted(problem, requirements, effort.stop); broken.valid())
    return {Is::fails, broken, {}};
  Progress progress;
  progress.order = refutations_->in_order(requirements);
  progress.decisions.resize(progress.order.size());
  progress.explored.resize(progress.order.size());
  const std::vector<Verdict> bounds = bounds_of(problem, progress.order, options_);
  Options options = options_;
  options.stop = effort.stop;
  options.max_states = effort.classes;
  for (const AskingRound& round : asking_rounds()) {
    if (effort.classes < round.from) break;
    for (std::size_t k = 0; k < progress.order.size() && !progress.failing() && !effort.over(); ++k)
      decide(round.methods,
             AskedCase{problem, progress.order[k], bounds[k], workers_, progress.decisions[k],
                       progress.explored[k]},
             options);
  }
  return ruling_of(problem, std::move(progress), effort);
}

Ruling RequirementChecker::ask(const Problem& problem, const RequirementIds& requirements) {
  return ask(problem, requirements, {options_.max_states, options_.stop});
}

RequirementIds requirements_of(const Problem& problem) {
  RequirementIds all;
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) all.emplace_back(r);
  return all;
}

}  // namespace pal::analyzer::whatif
