// A method that follows an edge. While the tool touches something it keeps still, and does not look at the
// edge.
#include <catch2/catch.hpp>

#include "analyzer/analysis.hpp"
#include "tests/support/confirm.hpp"
#include "tests/support/project_file.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

std::unique_ptr<test::Skill> edge_on(const std::string& workcell) {
  const std::string folder = "tests/reference/follow_edge/";
  return test::sound_skill(test::project_file(folder + "skill.pal") +
                           test::project_file(folder + workcell + ".pal"));
}

Verdict age_of(const test::Skill& skill) {
  const Analysis analysis = analyze(*skill.problem, AnalysisChoice::automatic);
  CHECK(test::unconfirmed(*skill.problem, analysis) == "");
  return analysis.verdicts.front();
}

}  // namespace

// Contact must come before the method asks for it, go before it looks again 0.35 ms later, and come again.
// That happens in a run out of some thousand.
TEST_CASE("with three processors the method keeps still twice, and the edge is too old") {
  const Verdict age = age_of(*edge_on("three"));
  CHECK(age.state == VerdictState::fails);
  REQUIRE(age.witness);
  CHECK(age.witness->measured.value > 200'000'000);
}

// The work of others delays a request for the next frame, so that a frame is lost. That happens where the
// drifting phases of tick and frame meet.
TEST_CASE("with one processor a frame is lost, and the edge is too old") {
  const Verdict age = age_of(*edge_on("one"));
  CHECK(age.state == VerdictState::fails);
  REQUIRE(age.witness);
  CHECK(age.witness->measured.value > 200'000'000);
}

// What it reads and what it tests afterwards agree: who could set it in between has a lower priority. So it
// keeps still once at most, and then leaves its loop.
TEST_CASE("with two processors the method keeps still once, and the edge is young enough") {
  const Verdict age = age_of(*edge_on("two"));
  CHECK(age.state == VerdictState::holds);
  REQUIRE(age.bound);
  CHECK(*age.bound <= Duration(200'000'000));
  CHECK(age.statistics.classes < 250'000);
}
