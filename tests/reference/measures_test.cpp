// Case 3 of the timing design, proved: the range finder of section 5.3.3, frames of 76 ms with a gap of 2 ms.
// And the measures that it takes.
#include <catch2/catch.hpp>

#include "analyzer/exact/exact.hpp"
#include "tests/reference/range_finder.hpp"
#include "tests/support/confirm.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::sound_skill;
using namespace std::chrono_literals;

namespace {

const char* const asks_after = R"(
  REPEAT
    TXM( request profile from finder )
    WTM( profile from finder )
    interpret
  UNTIL( forever ))";

const char* const asks_before = R"(
  TXM( request profile from finder )
  REPEAT
    WTM( profile from finder )
    TXM( request profile from finder )
    interpret
  UNTIL( forever ))";

const char* const losses_and_pace = R"(
  REQUIREMENT each   : LOSS OF finder NONE
  REQUIREMENT second : LOSS OF finder AT MOST 1 IN 2
  REQUIREMENT pace   : INTERVAL OF interpret IN SD1 BETWEEN 60 ms AND 160 ms
  REQUIREMENT take   : INTERVAL OF WTM( profile from finder ) IN SD1 BETWEEN 78 ms AND 78 ms
)";

const Verdict& verdict_of(const Analysis& analysis, const std::string& requirement) {
  for (const Verdict& each : analysis.verdicts) {
    if (each.requirement == requirement) return each;
  }
  throw std::runtime_error("no requirement " + requirement);
}

/// `bound` is what a run attains, and no run exceeds.
void expect_exact(const Analysis& analysis, const std::string& requirement, Duration bound,
                  VerdictState state) {
  const Verdict& found = verdict_of(analysis, requirement);
  INFO(requirement << ": " << name(found.state) << ", " << found.explanation.text());
  REQUIRE(found.bound);
  CHECK(*found.bound == bound);
  CHECK(found.exact);
  CHECK(found.state == state);
  REQUIRE(found.witness);
  CHECK(found.witness->measured.value == bound.count());
  CHECK(test::unexplained(found) == "");
}

constexpr VerdictState holds = VerdictState::holds;
constexpr VerdictState fails = VerdictState::fails;

}  // namespace

TEST_CASE("case 3: asking after interpreting, every second frame is lost, one result each 156 ms") {
  const auto skill = sound_skill(test::range_finder(asks_after, "10 TO 15 ms", losses_and_pace));
  const Analysis analysis = analyze_exactly(*skill->problem);
  expect_exact(analysis, "each", 1ns, fails);
  expect_exact(analysis, "second", 1ns, holds);
  expect_exact(analysis, "take.least", 156ms, holds);
  expect_exact(analysis, "take.most", 156ms, fails);
  expect_exact(analysis, "pace.least", 151ms, holds);
  expect_exact(analysis, "pace.most", 161ms, fails);
}

TEST_CASE("case 3: asking before interpreting, none is lost, one result each 78 ms") {
  const auto skill = sound_skill(test::range_finder(asks_before, "10 TO 15 ms", losses_and_pace));
  const Analysis analysis = analyze_exactly(*skill->problem);
  expect_exact(analysis, "each", 0ns, holds);
  expect_exact(analysis, "take.least", 78ms, holds);
  expect_exact(analysis, "take.most", 78ms, holds);
  expect_exact(analysis, "pace.least", 73ms, holds);
  expect_exact(analysis, "pace.most", 83ms, holds);
}

TEST_CASE("case 3: an interpretation of 78 ms still loses none, a longer one does") {
  const char* const loss = "  REQUIREMENT each : LOSS OF finder NONE\n";
  expect_exact(analyze_exactly(*sound_skill(test::range_finder(asks_before, "10 TO 78 ms", loss))->problem),
               "each", 0ns, holds);
  expect_exact(analyze_exactly(*sound_skill(test::range_finder(asks_before, "10 TO 79 ms", loss))->problem),
               "each", 1ns, fails);
}

TEST_CASE(
    "case 3: a frame is as old as it takes to collect and to interpret, the world up to a frame older") {
  const char* const ages = R"(
  REQUIREMENT fresh    : AGE OF profile FROM finder AT interpret IN SD1 AT MOST 100 ms
  REQUIREMENT reaction : REACTION OF profile FROM finder AT interpret IN SD1 AT MOST 200 ms
  REQUIREMENT busy     : BUSY PERIOD OF P1 AT MOST 15 ms
)";
  const Analysis before =
      analyze_exactly(*sound_skill(test::range_finder(asks_before, "10 TO 15 ms", ages))->problem);
  expect_exact(before, "fresh", 91ms, holds);
  expect_exact(before, "reaction", 169ms, holds);  // 78 + 76 + 15
  expect_exact(before, "busy", 15ms, holds);
  const Analysis after =
      analyze_exactly(*sound_skill(test::range_finder(asks_after, "10 TO 15 ms", ages))->problem);
  expect_exact(after, "fresh", 91ms, holds);
  expect_exact(after, "reaction", 247ms, fails);  // 2 · 78 + 76 + 15
}

TEST_CASE("case 3: the referee confirms the runs behind all of this") {
  for (const char* body : {asks_after, asks_before}) {
    const auto skill = sound_skill(test::range_finder(body, "10 TO 15 ms", losses_and_pace));
    CHECK(test::unconfirmed(*skill->problem, analyze_exactly(*skill->problem)) == "");
  }
}

TEST_CASE("the skill may end whenever the robot stops it, and never with an error") {
  const char* const ends = R"(
  REQUIREMENT normal : DURATION TO COMPLETION 0 AT MOST 1 s
  REQUIREMENT error  : DURATION TO COMPLETION 1 AT MOST 1 s
)";
  const Analysis analysis =
      analyze_exactly(*sound_skill(test::range_finder(asks_before, "15 ms", ends))->problem);
  const Verdict& normal = verdict_of(analysis, "normal");
  CHECK(normal.state == fails);
  CHECK_FALSE(normal.bound);
  REQUIRE(normal.witness);
  CHECK(normal.witness->measured.value > 1'000'000'000);
  CHECK(verdict_of(analysis, "error").state == VerdictState::never);
}
