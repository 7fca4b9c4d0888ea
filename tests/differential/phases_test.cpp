// Requirements on a part of each run: the exploration against all runs that are made without the analyzer,
// with and without a slice; the compositional bounds and single runs against both.
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

using namespace pal;
using namespace pal::analyzer;

namespace {

constexpr Duration unit(1'000'000);
constexpr int cap = 1500;

/// Bounds in units, by name; -1: never; -2: none.
using Bounds = std::map<std::string, std::int64_t>;

std::int64_t shown(const Verdict& verdict) {
  if (verdict.state == Verdict::State::never) return -1;
  if (!verdict.bound) return -2;
  return verdict.measure == Requirement::Measure::loss ? verdict.bound->count() : *verdict.bound / unit;
}

/// The exact bounds of all requirements, which every independent judge agrees with.
Bounds bounds_of(const std::string& name) {
  const std::string text = test::program("phases/" + name);
  const auto skill = test::meaningful_skill(text);
  const Problem& problem = *skill->problem;
  const Analysis exact = analyze_exactly(problem);
  CHECK(test::unconfirmed(problem, exact) == "");
  const pan::Network& network = skill->specification.skills.front();
  const pan::Environment& environment = skill->specification.environments.front();
  Bounds bounds;
  for (const test::Wanted& wanted : test::wanted(network, environment)) {
    const Verdict* verdict = nullptr;
    for (const Verdict& each : exact.verdicts) {
      if (each.requirement == wanted.name) verdict = &each;
    }
    REQUIRE(verdict != nullptr);
    INFO(wanted.name << ": " << verdict->explanation);
    CHECK(test::unexplained(*verdict) == "");
    test::AllRuns runs(network, environment, wanted, unit, cap);
    const test::Seen seen = runs.enumerate(300'000);
    CHECK(seen.complete);
    CHECK(test::contradiction(wanted, seen, *verdict, unit, cap) == "");
    const bool least = wanted.kind == test::Wanted::Kind::least;
    const bool measured = (least ? seen.least : seen.greatest) >= 0 || seen.failed || seen.unanswered;
    CHECK((verdict->state != Verdict::State::never) == measured);
    bounds[wanted.name] = shown(*verdict);
  }
  const Analysis compositional = analyze_compositionally(problem);
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
    const Verdict& bound = compositional.verdicts[r];
    const Verdict& known = exact.verdicts[r];
    INFO(bound.requirement << ": " << bound.explanation);
    const bool both = bound.bound && known.bound && known.witness;
    if (both) CHECK((bound.at_least ? *bound.bound <= *known.bound : *bound.bound >= *known.bound));
    if (bound.bound) CHECK(known.state != Verdict::State::fails);
  }
  return bounds;
}

}  // namespace

TEST_CASE("a phase leaves out start-up and contingency") {
  // A tick every 10 ms, 1 to 2 ms for each, 1 to 3 ms for a level. Start-up settles for up to 22 ms, the
  // contingency retreats for 24.
  CHECK(bounds_of("loop") == Bounds{{"age-run", 34},
                                    {"age-loop", 34},
                                    {"age-after", 24},
                                    {"sample-run", 37},
                                    {"sample-loop", 37},
                                    {"response-run", -2},
                                    {"response-loop", 2},
                                    {"response-after", -2},
                                    {"interval-run", 27},
                                    {"interval-loop", 11},
                                    {"interval-after", 27},
                                    {"least-loop", 9},
                                    {"least-after", 9},
                                    {"reaction-run", 61},
                                    {"reaction-loop", 22},
                                    {"reaction-after", 37},
                                    {"noticed-loop", 22},
                                    {"noticed-after", 39},
                                    {"loss-run", 1},
                                    {"loss-loop", 0},
                                    {"loss-after", -1},
                                    {"whole", -2},
                                    {"rest", 0}});
}

TEST_CASE("a phase may be a loop of another module, with what it executes") {
  // Before and behind the loop SM1 thinks for 6 ms, on MC1's processor and before it.
  CHECK(bounds_of("other_module") == Bounds{{"age-loop", 8},
                                            {"age-run", 8},
                                            {"response-loop", 6},
                                            {"response-run", 12},
                                            {"response-tail", 6},
                                            {"interval-loop", 18},
                                            {"interval-run", 18},
                                            {"reaction-loop", 22},
                                            {"reaction-tail", 22},
                                            {"loss-loop", 0},
                                            {"loss-run", 0}});
}

TEST_CASE("a phase that begins at one instant with what is measured comes before it and behind it") {
  CHECK(bounds_of("one_instant") == Bounds{{"after-take", 8},
                                           {"after-put", 8},
                                           {"put-to-put", 4},
                                           {"in-loop", 8},
                                           {"out-of-loop", 10},
                                           {"reaction-loop", 2},
                                           {"reaction-put", 12},
                                           {"whole", 8}});
}
