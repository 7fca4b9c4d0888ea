// Places that can be found by hand.
#include <catch2/catch.hpp>

#include "analyzer/whatif/placement.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using namespace pal::analyzer::whatif;

namespace {

/// Two loops, each woken by a clock.
std::unique_ptr<test::Skill> two_loops(const std::string& requirements, const std::string& environment) {
  return test::sound_skill(R"(MESSAGE tick : SIGNAL
MESSAGE tock : SIGNAL
SKILL s
  MACHINE CONTROLLER MC1
  SENSOR DRIVER SD1
  LOGICAL SENSOR LS1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
)" + requirements + R"(END SKILL
Machine Controller: MC1
Sensor Driver: SD1
Logical Sensor: LS1
  ACTIVITY light
BEGIN
  REPEAT
    WTM( tock from SD1 )
    light
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY heavy
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( tick from MC1 )
    heavy
  UNTIL( forever )
END
ENVIRONMENT cell
)" + environment + R"(  PLACE SM1 ON P0 PRIORITY 2
  PLACE LS1 ON P0 PRIORITY 1
END ENVIRONMENT
)");
}

const std::string slow_clocks =
    "  DEVICE MC1 EVENT tick EVERY 10 ms\n  DEVICE SD1 EVENT tock EVERY 10 ms\n"
    "  TIME heavy OF SM1 : 5 ms\n  TIME light OF LS1 : 1 ms\n";

std::vector<Placements> fewest(const test::Skill& skill, bool priorities) {
  RequirementChecker checker(skill.specification.skills.front(), Options());
  PlacementOptions how;
  how.priorities = priorities;
  return fewest_processors(skill.specification.environments.front(), checker, how);
}

int processor_of(const Placed& placed, const std::string& thread) {
  for (const ThreadPlacement& each : placed.threads) {
    if (each.thread == thread) return each.processor.value;
  }
  return -1;
}

}  // namespace

TEST_CASE("a processor that a requirement names is not like the others") {
  const auto skill =
      two_loops("  REQUIREMENT quiet : LOAD OF P0 AT MOST 20 %\n", "  PROCESSOR P0\n" + slow_clocks);
  const auto all = fewest(*skill, false);
  REQUIRE(all.size() == 2);
  CHECK(all.front().tried == 1);
  CHECK(all.front().refuted.size() == 1);
  REQUIRE(all.back().meet.size() == 1);
  CHECK(processor_of(all.back().meet.front(), "LS1") == 0);
  CHECK(processor_of(all.back().meet.front(), "SM1") == 1);
}

TEST_CASE("a processor of another kind may be the one that suffices") {
  const auto skill =
      two_loops("  REQUIREMENT soon : RESPONSE FROM tick OF MC1 TO heavy IN SM1 AT MOST 5 ms\n",
                "  PROCESSOR P0 NONPREEMPTIVE\n  PROCESSOR P1\n" + slow_clocks);
  const auto all = fewest(*skill, false);
  REQUIRE(all.size() == 1);
  CHECK(all.front().tried == 2);
  CHECK(all.front().refuted.size() == 1);
  REQUIRE(all.front().meet.size() == 1);
  CHECK(processor_of(all.front().meet.front(), "SM1") == 1);
}

TEST_CASE("processors that are alike are interchangeable") {
  const auto skill =
      two_loops("  REQUIREMENT soon : RESPONSE FROM tick OF MC1 TO heavy IN SM1 AT MOST 5 ms\n",
                "  PROCESSOR P0\n  PROCESSOR P1\n  PROCESSOR P2 NONPREEMPTIVE\n" + slow_clocks);
  RequirementChecker checker(skill->specification.skills.front(), Options());
  PlacementOptions how;
  // On P0 and P1; on one of them and P2, either way.
  CHECK(placements_on(2, skill->specification.environments.front(), checker, how).tried == 3);
  how.priorities = true;
  // On one that is preemptive or on P2: either first, or equal.
  CHECK(placements_on(1, skill->specification.environments.front(), checker, how).tried == 6);
  CHECK(placements_on(3, skill->specification.environments.front(), checker, how).tried == 0);
}

// One after the other, each waits for the other at most once: 2 ms. Of two that have an order the last waits
// for the next tick of the first as well.
TEST_CASE("where no order of two threads does, equals may") {
  const auto skill = two_loops(
      "  REQUIREMENT one : RESPONSE FROM tick OF MC1 TO heavy IN SM1 AT MOST 2 ms\n"
      "  REQUIREMENT other : RESPONSE FROM tock OF SD1 TO light IN LS1 AT MOST 2 ms\n",
      "  PROCESSOR P0\n  DEVICE MC1 EVENT tick EVERY 2 ms\n  DEVICE SD1 EVENT tock EVERY 2 ms\n"
      "  TIME heavy OF SM1 : 1 ms\n  TIME light OF LS1 : 1 ms\n");
  const auto all = fewest(*skill, true);
  REQUIRE(all.size() == 1);
  CHECK(all.front().tried == 3);
  CHECK(all.front().refuted.size() == 2);
  REQUIRE(all.front().meet.size() == 1);
  const std::vector<ThreadPlacement>& threads = all.front().meet.front().threads;
  CHECK(threads[0].priority == threads[1].priority);
}
