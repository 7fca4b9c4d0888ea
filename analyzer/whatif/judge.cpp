#include "analyzer/whatif/judge.hpp"

#include <algorithm>

namespace pal::analyzer {
namespace {

/// More would take longer to try than they spare.
constexpr std::size_t most_refutations = 12;

}  // namespace

/// With figures that have no great common divisor the states of a load are without number: rather undecided
/// soon.
Options Judge::options_for(const Problem& problem, std::size_t requirement) const {
  Options options = options_;
  const auto known = cost_.find(requirement);
  if (problem.requirements[requirement].measure == Requirement::Measure::load && known != cost_.end())
    options.max_states = std::min(options.max_states, 4 * known->second + 1'000);
  return options;
}

std::optional<Problem> Judge::problem(const pan::Environment& environment) const {
  Diagnostics ignored;
  return make_problem(network_, environment, ignored);
}

int Judge::refuted(const Problem& problem, const std::vector<std::size_t>& requirements) {
  for (const Refutation& known : refutations_) {
    const bool asked =
        std::find(requirements.begin(), requirements.end(), known.requirement) != requirements.end();
    if (asked && refutes(problem, known.requirement, known.witness))
      return static_cast<int>(known.requirement);
  }
  return -1;
}

Ruling Judge::ask(const Problem& problem, const std::vector<std::size_t>& requirements) {
  if (const int known = refuted(problem, requirements); known >= 0) return {Verdict::State::fails, known};
  std::vector<std::size_t> order;
  for (std::size_t r : failed_) {
    if (std::find(requirements.begin(), requirements.end(), r) != requirements.end()) order.push_back(r);
  }
  for (std::size_t r : requirements) {
    if (std::find(order.begin(), order.end(), r) == order.end()) order.push_back(r);
  }
  Ruling ruling{Verdict::State::holds, -1};
  for (std::size_t r : order) {
    if (stopped()) return {Verdict::State::undecided, static_cast<int>(r)};
    Decision decision = decide(problem, r, options_for(problem, r), workers_);
    if (problem.requirements[r].measure == Requirement::Measure::load && decision.classes > 0)
      cost_.emplace(r, decision.classes);
    if (decision.state == Verdict::State::holds) continue;
    ruling = {decision.state, static_cast<int>(r)};
    if (decision.state != Verdict::State::fails) continue;
    std::erase(failed_, r);
    failed_.insert(failed_.begin(), r);
    const Requirement::Measure measure = problem.requirements[r].measure;
    const bool one_run = measure != Requirement::Measure::load && measure != Requirement::Measure::busy;
    if (decision.witness && one_run) {
      refutations_.insert(refutations_.begin(), {r, std::move(*decision.witness)});
      if (refutations_.size() > most_refutations) refutations_.pop_back();
    }
    return ruling;
  }
  return ruling;
}

}  // namespace pal::analyzer
