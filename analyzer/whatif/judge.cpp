#include "analyzer/whatif/judge.hpp"

#include <algorithm>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/exact/zeno_run.hpp"

namespace pal::analyzer {
namespace {

/// More would take longer to try than they spare.
constexpr std::size_t most_refutations = 12;

/// They cost next to nothing, and often suffice.
std::vector<Verdict> bounds_of(const Problem& problem, const std::vector<std::size_t>& requirements,
                               Options options) {
  Problem asked = problem;
  asked.requirements.clear();
  for (const std::size_t r : requirements) asked.requirements.push_back(problem.requirements[r]);
  options.addends = false;
  return analyze_compositionally(asked, options).verdicts;
}

}  // namespace

std::optional<Problem> Judge::problem(const pan::Environment& environment) const {
  Diagnostics ignored;
  return make_problem(network_, environment, ignored);
}

int Judge::refuted(const Problem& problem, const std::vector<std::size_t>& requirements) {
  for (const Refutation& known : refutations_) {
    const bool asked =
        std::find(requirements.begin(), requirements.end(), known.requirement) != requirements.end();
    if (stopped()) return -1;
    if (asked && refutes(problem, known.requirement, known.witness, options_.stop))
      return static_cast<int>(known.requirement);
  }
  return -1;
}

bool Judge::bounded(const Problem& problem, const std::vector<std::size_t>& requirements) const {
  const std::vector<Verdict> bounds = bounds_of(problem, requirements, options_);
  return std::all_of(bounds.begin(), bounds.end(),
                     [](const Verdict& bound) { return bound.state == Verdict::State::holds; });
}

bool Judge::has_zeno_run(const Problem& problem) {
  return find_zeno_run(problem, {options_.max_states, options_.stop, {}, &workers_}).found.has_value();
}

Ruling Judge::ask(const Problem& problem, const std::vector<std::size_t>& requirements) {
  if (const int broken = refuted(problem, requirements); broken >= 0) return {Verdict::State::fails, broken};
  std::vector<std::size_t> order;
  for (std::size_t r : failed_) {
    if (std::find(requirements.begin(), requirements.end(), r) != requirements.end()) order.push_back(r);
  }
  for (std::size_t r : requirements) {
    if (std::find(order.begin(), order.end(), r) == order.end()) order.push_back(r);
  }
  Ruling ruling{Verdict::State::holds, -1};
  bool known = true;
  const std::vector<Verdict> bounds = bounds_of(problem, order, options_);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t r = order[k];
    if (stopped()) return {Verdict::State::undecided, static_cast<int>(r)};
    Decision decision = decide(problem, r, bounds[k], options_, workers_);
    known = known && decision.excess;
    ruling.excess = known ? std::max(ruling.excess.value_or(*decision.excess), *decision.excess)
                          : std::optional<Nanoseconds>();
    if (decision.state == Verdict::State::holds) continue;
    ruling.state = decision.state;
    ruling.requirement = static_cast<int>(r);
    if (decision.state != Verdict::State::fails) continue;
    std::erase(failed_, r);
    failed_.insert(failed_.begin(), r);
    if (decision.witness) {
      refutations_.insert(refutations_.begin(), {r, std::move(*decision.witness)});
      if (refutations_.size() > most_refutations) refutations_.pop_back();
    }
    return ruling;
  }
  return ruling;
}

}  // namespace pal::analyzer
