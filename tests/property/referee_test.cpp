// Skills in which it is easy to be wrong about what a run is.
#include <catch2/catch.hpp>

#include "analyzer/exact/exact.hpp"
#include "analyzer/run_checker/check_run.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/confirm.hpp"
#include "tests/support/project_file.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

/// The text of a skill in tests/property/referee.
std::string referee(const std::string& name) {
  return test::project_file("tests/property/referee/" + name + ".pal");
}

/// Runs of a skill that the rules refuse, by their seeds.
std::string refused_runs(const std::string& text, SimulationOptions::Times times) {
  const auto skill = test::sound_skill(text);
  const Watch nothing;
  const Machine machine(*skill->problem, nothing);
  std::string refused;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SimulationOptions how;
    how.times = times;
    how.seed = seed;
    how.until = 100'000'000;
    const std::string broken =
        run_checker::check_run(*skill->problem, nullptr, simulate(machine, how).trace).broken;
    if (!broken.empty()) refused += std::to_string(seed) + ": " + broken + "\n";
  }
  return refused;
}

}  // namespace

TEST_CASE("an age is explained by the value that was read, not by later messages") {
  const auto skill = test::sound_skill(referee("read_before_said"));
  Options options;
  options.max_states = 2'500;
  const Analysis analysis = analyze_exactly(*skill->problem, options);
  const Verdict& age = analysis.verdicts.front();
  REQUIRE(age.witness);
  REQUIRE_FALSE(age.reasons.empty());
  CHECK(test::unexplained(age) == "");
}

TEST_CASE("a thread that goes on at the instant of its end keeps its processor busy") {
  const auto skill = test::sound_skill(referee("spinning"));
  const Analysis analysis = analyze_exactly(*skill->problem);
  const Verdict& pause = analysis.verdicts.front();
  REQUIRE(pause.state == Verdict::State::fails);
  REQUIRE(pause.witness);
  CHECK(pause.witness->grows);
  CHECK(test::unconfirmed(*skill->problem, analysis) == "");
}

// LS1 gives up while SD1 is receiving an event: the request that it withdraws is not what SD1 receives.
TEST_CASE("withdrawing one message does not touch the one that is being taken") {
  CHECK(refused_runs(referee("withdrawn_beside"), SimulationOptions::Times::random) == "");
}

// LS1.1 takes the next request, of the instant at which the one before is withdrawn: it did not have that
// one.
TEST_CASE("a receiver may never have had the message that was withdrawn") {
  CHECK(refused_runs(referee("next_message"), SimulationOptions::Times::extremes) == "");
}

// SM1.1 takes a message, which frees LS1, and ends, which cancels SM1.2: LS1 or SM1 is the first in the
// queue.
TEST_CASE("one instant: a freed sender and the parent of the thread that freed it join a queue") {
  CHECK(refused_runs(referee("freed_sender"), SimulationOptions::Times::worst) == "");
}
