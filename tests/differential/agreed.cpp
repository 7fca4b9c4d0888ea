#include "tests/differential/agreed.hpp"

#include <catch2/catch.hpp>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/exact/cap.hpp"
#include "analyzer/exact/exact.hpp"
#include "analyzer/exact/slice_bound.hpp"
#include "analyzer/run_checker/check_run.hpp"
#include "analyzer/runs/simulate.hpp"
#include "analyzer/slice/slice.hpp"
#include "tests/differential/by_hand.hpp"
#include "tests/differential/contradiction.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/confirm.hpp"
#include "tests/support/runs/all_runs.hpp"

using namespace pal::analyzer;

namespace pal::test {
namespace {

constexpr Duration unit(1'000'000);
constexpr int cap = 1500;
constexpr std::size_t most_states = 300'000;
constexpr std::uint64_t most_simulated = 12;

/// On a processor and with a device of its own.
const char* const bystander = R"(
MESSAGE blink : SIGNAL
MESSAGE lamp  : SIGNAL

Machine Controller: Bystander
  ACTIVITY shine
BEGIN
  REPEAT
    WTM( blink from blinker )
    shine
    TXM( lamp to blinker )
  UNTIL( forever )
END

DEVICE blinker
)";

const char* const place_of_bystander = R"(  PROCESSOR Beside
  PLACE Bystander ON Beside PRIORITY 1
  TIME shine : 0 TO 3 ms
  DEVICE blinker EVENT blink EVERY 7 ms
END ENVIRONMENT)";

std::string with_bystander(std::string text) {
  const std::string listed = "  MACHINE CONTROLLER ";
  const std::string method = "  SKILL METHOD";
  const std::size_t list = text.find(listed);
  if (list == std::string::npos) {
    text.insert(text.find(method), listed + "Bystander\n");
  } else {
    text.insert(list + listed.size(), "Bystander, ");
  }
  const std::string end = "END ENVIRONMENT";
  text.replace(text.find(end), end.size(), place_of_bystander);
  return text + bystander;
}

std::int64_t known_as(const Verdict& verdict) {
  if (verdict.state == Verdict::State::never) return never_measured;
  if (!verdict.bound) return without_bound;
  return verdict.measure == Requirement::Measure::loss ? verdict.bound->count() : *verdict.bound / unit;
}

const Verdict& verdict_of(const Analysis& analysis, const std::string& requirement) {
  for (const Verdict& each : analysis.verdicts) {
    if (each.requirement == requirement) return each;
  }
  throw std::runtime_error("no verdict of " + requirement);
}

void expect_all_runs_agree(const Skill& skill, const Wanted& wanted, const Verdict& verdict) {
  const pan::Network& network = skill.specification.skills.front();
  const pan::Environment& environment = skill.specification.environments.front();
  AllRuns runs(network, environment, wanted, unit, cap);
  const Seen seen = runs.enumerate(most_states);
  CHECK(seen.complete);
  CHECK(contradiction(wanted, seen, verdict, unit, cap) == "");
  const bool least = wanted.kind == Wanted::Kind::least;
  const bool measured = (least ? seen.least : seen.greatest) >= 0 || seen.failed || seen.unanswered;
  CHECK((verdict.state != Verdict::State::never) == measured);
  if (verdict.bound) CHECK(verdict.exact);
}

void expect_bounds_hold(const Problem& problem, const Analysis& exact) {
  const Analysis compositional = compositional::analyze(problem);
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
    const Verdict& bound = compositional.verdicts[r];
    const Verdict& known = exact.verdicts[r];
    INFO(bound.requirement << ": " << bound.explanation.text());
    if (!bound.bound || known.state == Verdict::State::never) continue;
    REQUIRE(known.bound);
    CHECK((bound.at_least ? *bound.bound <= *known.bound : *bound.bound >= *known.bound));
  }
}

/// Of simulated runs the run checker measures what the simulator does, and that is within the bound.
void expect_simulated_runs_agree(const Problem& problem, const Requirement& requirement,
                                 const Verdict& known) {
  const Watch watch = watch_of(problem, requirement);
  const Machine machine(problem, watch);
  for (std::uint64_t seed = 1; seed <= most_simulated; ++seed) {
    SimulationOptions options;
    options.seed = seed;
    options.times = seed % 2 == 0 ? SimulationOptions::Times::random : SimulationOptions::Times::extremes;
    options.until = 200 * unit.count();
    const Simulation run = simulate(machine, options);
    const run_checker::Ruling ruling = run_checker::check_run(problem, &requirement, run.trace);
    INFO("seed " << seed);
    CHECK(ruling.broken == "");
    CHECK(ruling.failed == run.failed);
    for (const Measurement& each : run.measured) {
      CHECK(known.state != Verdict::State::never);
      CHECK(shows(ruling, each));
      const bool kept = !known.bound || (known.at_least ? each.value >= known.bound->count()
                                                        : each.value <= known.bound->count());
      CHECK(kept);
    }
    if (requirement.measure != Requirement::Measure::loss)
      CHECK(ruling.measured.size() == run.measured.size());
  }
}

}  // namespace

Bounds agreed_bounds(const std::string& name) {
  const auto skill = meaningful_skill(program(name));
  const Problem& problem = *skill->problem;
  const Analysis exact = analyze_exactly(problem);
  CHECK(unconfirmed(problem, exact) == "");
  Bounds bounds;
  for (const Wanted& wanted :
       wanted(skill->specification.skills.front(), skill->specification.environments.front())) {
    const Verdict& verdict = verdict_of(exact, wanted.name);
    INFO(wanted.name << ": " << verdict.explanation.text());
    CHECK(unexplained(verdict) == "");
    expect_all_runs_agree(*skill, wanted, verdict);
    for (const Requirement& requirement : problem.requirements) {
      if (requirement.name == wanted.name) expect_simulated_runs_agree(problem, requirement, verdict);
    }
    bounds[wanted.name] = known_as(verdict);
  }
  expect_bounds_hold(problem, exact);
  return bounds;
}

Bounds explored_bounds(const std::string& name) {
  Bounds bounds;
  for (const Verdict& verdict : analyze_exactly(*meaningful_skill(program(name))->problem).verdicts) {
    if (known_as(verdict) >= 0) bounds[verdict.requirement] = known_as(verdict);
  }
  return bounds;
}

Bounds sliced_bounds(const std::string& name) {
  const auto skill = meaningful_skill(with_bystander(program(name)));
  const Problem& problem = *skill->problem;
  Bounds bounds;
  for (const Requirement& requirement : problem.requirements) {
    INFO(requirement.name);
    const Cone cone = cone_of(problem, requirement);
    CHECK_FALSE(cone.whole());
    const SliceBound found = bound_in(slice_of(problem, cone, {false, false}), requirement,
                                      cap_of(problem, requirement.limit), {most_states, {}, {}, nullptr});
    CHECK(found.complete);
    const bool number = requirement.measure == Requirement::Measure::loss;
    if (found.bound) bounds[requirement.name] = *found.bound / (number ? 1 : unit.count());
  }
  return bounds;
}

Bounds proved_bounds(const std::string& name) {
  const auto skill = meaningful_skill(program(name));
  const Problem& problem = *skill->problem;
  Options options;
  options.threads = 1;
  Bounds bounds;
  for (const Requirement& requirement : problem.requirements) {
    INFO(requirement.name);
    CHECK_FALSE(cone_of(problem, requirement).whole());
    const SliceBound found = slice_bound(problem, requirement, options, most_states);
    CHECK(found.complete);
    if (found.bound) bounds[requirement.name] = *found.bound / unit.count();
  }
  return bounds;
}

}  // namespace pal::test
