#include "analyzer/first_look.hpp"

#include <algorithm>
#include <utility>

#include "analyzer/deciding.hpp"
#include "analyzer/machine/loss_rows.hpp"
#include "analyzer/problem/budgets.hpp"
#include "analyzer/verdict/sentence.hpp"

namespace pal::analyzer {
namespace {

/// Whether a bound settles a load.
bool settled_load(const Verdict& bound) {
  return bound.measure == Requirement::Measure::load && bound.state == VerdictState::holds;
}

/// The classes of each requirement that holds by a bound, if so many of them do; 0: it is not explored.
std::size_t glance_at_held(const Problem& problem, std::size_t held) {
  const std::size_t whole = glance(problem);
  const std::size_t share =
      whole * (budget::most_of_held / budget::brief_exploration) / std::max<std::size_t>(held, 1);
  return share < budget::least_of_held ? 0 : std::min(whole, share);
}

template <class Key, class Value>
bool same(const Table<Key, Value>& one, const Table<Key, Value>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end());
}

/// Whether two requirements measure the same, perhaps with other limits.
bool measure_the_same(const Requirement& one, const Requirement& other) {
  return one.measure == other.measure && one.condition == other.condition && one.samples == other.samples &&
         one.events == other.events && one.device == other.device && same(one.at, other.at) &&
         same(one.phase.after, other.phase.after) && same(one.phase.during, other.phase.during) &&
         one.processors == other.processors && one.in == other.in && one.code == other.code &&
         one.at_least == other.at_least;
}

/// Explores one requirement after the other, loads last, and tells what is known by then: of what has not
/// been looked at only bounds.
void look_at_each(const Provers& provers, const Problem& problem, const Options& options,
                  const std::vector<std::size_t>& which, Analysis& all) {
  Problem part = problem;
  std::size_t most = budget::brief_look;
  std::vector<bool> seen(all.verdicts.size());
  for (const bool loads : {false, true}) {
    for (std::size_t i = 0; i < which.size(); ++i) {
      const Requirement& requirement = problem.requirements[which[i]];
      if ((requirement.measure == Requirement::Measure::load) != loads) continue;
      share_bounds(problem, all);
      Verdict& verdict = all.verdicts[which[i]];
      seen[which[i]] = true;
      if (verdict.state == VerdictState::undecided || verdict.method != Method::exact) {
        part.requirements = {requirement};
        Options how = options;
        if (!loads) how.max_states = std::min(how.max_states, most);
        Analysis shown = provers.exact(part, how);
        all.statistics += shown.statistics;
        verdict = std::move(shown.verdicts.front());
        if (!loads && verdict.gave_up) most = budget::briefer_look;
      }
      Analysis now = all;
      for (std::size_t r = 0; r < seen.size(); ++r) {
        if (!seen[r] && now.verdicts[r].state == VerdictState::holds)
          now.verdicts[r].state = VerdictState::undecided;
      }
      tell(options, now);
    }
  }
}

}  // namespace

void share_bounds(const Problem& problem, Analysis& analysis) {
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r) {
    Verdict& verdict = analysis.verdicts[r];
    if (verdict.state != VerdictState::undecided) continue;
    for (std::size_t s = 0; s < analysis.verdicts.size() && verdict.state == VerdictState::undecided; ++s) {
      const Verdict& other = analysis.verdicts[s];
      if (s == r || !other.bound || !measure_the_same(problem.requirements[r], problem.requirements[s]))
        continue;
      if (verdict.allowed().broken_by(*other.bound)) continue;
      Verdict shared = other;
      shared.requirement = verdict.requirement;
      shared.limit = verdict.limit;
      shared.where = verdict.where;
      shared.state = VerdictState::holds;
      shared.statistics = verdict.statistics;
      verdict = std::move(shared);
    }
  }
}

Analysis look_at_all(const Provers& provers, const Problem& problem, const Options& options,
                     const std::vector<Verdict>& bounds) {
  enum class Kind { open, held, settled_load };
  const auto kind_of = [&bounds](std::size_t r) {
    return settled_load(bounds[r])                  ? Kind::settled_load
           : bounds[r].state == VerdictState::holds ? Kind::held
                                                    : Kind::open;
  };
  Analysis all;
  all.verdicts = bounds;
  for (Verdict& verdict : all.verdicts) verdict.gave_up = true;
  for (const Kind kind : {Kind::open, Kind::held, Kind::settled_load}) {
    Problem part = problem;
    part.requirements.clear();
    std::vector<std::size_t> which;
    std::vector<std::pair<std::size_t, std::size_t>> twins;  // of a requirement that measures the same
    for (std::size_t r = 0; r < bounds.size(); ++r) {
      if (kind_of(r) != kind) continue;
      const auto twin = std::find_if(which.begin(), which.end(), [&](std::size_t other) {
        return measure_the_same(problem.requirements[other], problem.requirements[r]);
      });
      if (options.verdicts_only && kind == Kind::held && twin != which.end()) {
        twins.emplace_back(r, *twin);
        continue;
      }
      which.push_back(r);
      part.requirements.push_back(problem.requirements[r]);
    }
    const std::size_t classes = kind == Kind::open   ? glance(problem)
                                : kind == Kind::held ? glance_at_held(problem, which.size())
                                                     : budget::most_of_load;
    if (which.empty() || classes == 0) continue;
    Options how = options;
    how.max_states = std::min(options.max_states, classes);
    if (kind == Kind::open && options.verdicts_only) {
      look_at_each(provers, problem, how, which, all);
      continue;
    }
    Analysis shown = provers.exact(part, how);
    all.statistics += shown.statistics;
    for (std::size_t i = 0; i < which.size(); ++i) all.verdicts[which[i]] = std::move(shown.verdicts[i]);
    // One holds by its own bound; there is something to measure if there is for the other.
    for (const auto& [twin, other] : twins) {
      if (all.verdicts[other].state != VerdictState::never) continue;
      all.verdicts[twin].state = VerdictState::never;
      all.verdicts[twin].bound.reset();
      all.verdicts[twin].addends.clear();
      all.verdicts[twin].explanation = all.verdicts[other].explanation;
    }
  }
  return all;
}

void say_ends(const Problem& problem, const Options& options, Analysis& analysis) {
  const auto open = [](const Verdict& verdict) { return settled_load(verdict) && verdict.gave_up; };
  if (std::none_of(analysis.verdicts.begin(), analysis.verdicts.end(), open)) return;
  Options brief = options;
  brief.max_states = std::min(options.max_states, glance(problem));
  if (!every_run_ends(problem, brief)) return;
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r) {
    Verdict& verdict = analysis.verdicts[r];
    if (!open(verdict)) continue;
    verdict.state = VerdictState::never;
    verdict.bound.reset();
    verdict.addends.clear();
    verdict.explanation = nothing_measured(problem.requirements[r], true);
  }
}

std::optional<Verdict> by_shorter_rows(const Provers& provers, const Problem& problem,
                                       const Requirement& requirement, const Options& options) {
  if (requirement.measure != Requirement::Measure::loss ||
      requirement.in <= static_cast<int>(budget::short_row))
    return std::nullopt;
  Problem part = problem;
  part.requirements = {requirement};
  Options brief = options;
  brief.max_states = std::min(options.max_states, glance(problem));
  std::vector<std::pair<int, int>> shorter;
  std::optional<Verdict> known;
  for (int row = 1; row <= static_cast<int>(budget::longest_short_row) && row < requirement.in; row *= 2) {
    part.requirements.front().in = row;
    Verdict verdict = provers.exact(part, brief).verdicts.front();
    if (verdict.state == VerdictState::never) return std::nullopt;
    if (verdict.gave_up || !verdict.bound) return known;
    const auto lost = static_cast<int>(verdict.bound->count());
    shorter.emplace_back(row, lost);
    const int most = most_lost(requirement.in, shorter);
    if (known && Duration(most) >= *known->bound) continue;
    verdict.state = most <= requirement.limit ? VerdictState::holds : VerdictState::undecided;
    verdict.limit = Duration(requirement.limit);
    verdict.bound = Duration(most);
    verdict.exact = most == 0;
    if (!verdict.exact) verdict.witness.reset();
    verdict.reasons.clear();
    verdict.explanation = "Of any " + std::to_string(row) + " in a row at most " + std::to_string(lost) +
                          " are lost, so of any " + std::to_string(requirement.in) + " at most " +
                          std::to_string(most) + ".";
    known = std::move(verdict);
    if (known->state == VerdictState::holds) break;
  }
  return known;
}

}  // namespace pal::analyzer
