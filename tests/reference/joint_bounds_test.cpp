// Stages of one chain on one processor, delayed by others once together, beside the exact bound.
#include <catch2/catch.hpp>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/exact/exact.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::sound_skill;

namespace {

constexpr Nanoseconds ms = 1'000'000;

/// A chain of 44 ms in LS1 and 31 ms in SM1, and 68 ms of work in LS2, each once in 1000 ms.
std::string two_stages(int first, int second, int other, const std::string& after = "") {
  return R"(MESSAGE tick  : SIGNAL
MESSAGE tock  : SIGNAL
MESSAGE value : REAL N
CONDITION pc-high FROM value "high"
SKILL stages
  SENSOR DRIVER      SD1, SD2
  LOGICAL SENSOR     LS1, LS2
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT whole : RESPONSE FROM tick OF SD1 TO work AT MOST 900 ms
END SKILL
Sensor Driver: SD1
Sensor Driver: SD2
Logical Sensor: LS1
  ACTIVITY look WRITES value
BEGIN
  REPEAT
    WTM( tick from SD1 )
    look
    TXM( value to SM1 )
)" + after +
         R"(  UNTIL( forever )
END
Logical Sensor: LS2
  ACTIVITY disturb
BEGIN
  REPEAT
    WTM( tock from SD2 )
    disturb
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY work READS value
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( value from LS1 )
    work
    SPC( pc-high )
  UNTIL( pc-high )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P0
  DEVICE SD1 EVENT tick EVERY 1000 ms
  DEVICE SD2 EVENT tock EVERY 1000 ms
  TIME look : 44 ms
  TIME work : 31 ms
  TIME disturb : 68 ms
  PLACE LS1 ON P0 PRIORITY )" +
         std::to_string(first) + "\n  PLACE SM1 ON P0 PRIORITY " + std::to_string(second) +
         "\n  PLACE LS2 ON P0 PRIORITY " + std::to_string(other) + "\nEND ENVIRONMENT\n";
}

struct Bounds {
  Duration compositional;
  Duration exact;
  Nanoseconds addends = 0;
};

Bounds bounds_of(const std::string& text) {
  const auto skill = sound_skill(text);
  const Verdict bound = compositional::analyze(*skill->problem, {}).verdicts.at(0);
  const Verdict exact = analyze_exactly(*skill->problem, {}).verdicts.at(0);
  INFO(bound.explanation.text());
  REQUIRE(bound.bound);
  REQUIRE(exact.exact);
  Bounds found{*bound.bound, *exact.bound, 0};
  for (const Addend& each : bound.addends) found.addends += each.amount;
  return found;
}

}  // namespace

TEST_CASE("what delays two stages on one processor counts once for both") {
  const Bounds found = bounds_of(two_stages(2, 1, 3));
  CHECK(found.compositional == Duration(143 * ms));
  CHECK(found.exact == Duration(143 * ms));
  CHECK(found.addends == 143 * ms);
}

TEST_CASE("joint window: other threads may stand above one of the stages") {
  for (const auto& [first, second, other] :
       {std::tuple{1, 2, 3}, std::tuple{3, 1, 2}, std::tuple{1, 3, 2}, std::tuple{1, 1, 1}}) {
    INFO(first << " " << second << " " << other);
    const Bounds found = bounds_of(two_stages(first, second, other));
    CHECK(found.compositional == Duration(143 * ms));
    CHECK(found.exact <= found.compositional);
    CHECK(found.addends == 143 * ms);
  }
}

TEST_CASE("no other work delays stages above it") {
  const Bounds found = bounds_of(two_stages(3, 2, 1));
  CHECK(found.compositional == Duration(75 * ms));
  CHECK(found.exact == Duration(75 * ms));
}

TEST_CASE("asking two modules and waiting for both: the bound is near the exact one") {
  const Bounds found = bounds_of(R"(MESSAGE tick  : SIGNAL
MESSAGE left  : REAL N
MESSAGE right : REAL N
CONDITION pc-high FROM left "high"
SKILL join
  LOGICAL SENSOR     LS1, LS2
  MACHINE CONTROLLER MC1
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT whole : RESPONSE FROM tick OF MC1 TO work AT MOST 900 ms
END SKILL
Machine Controller: MC1
Logical Sensor: LS1
  ACTIVITY look WRITES left
BEGIN
  REPEAT
    WTM( request left from SM1 )
    look
    TXM( left to SM1 )
  UNTIL( forever )
END
Logical Sensor: LS2
  ACTIVITY see WRITES right
BEGIN
  REPEAT
    WTM( request right from SM1 )
    see
    TXM( right to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY work READS left, right
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( tick from MC1 )
    TXM( request left from LS1 )
    TXM( request right from LS2 )
    WTM( left from LS1 )
    WTM( right from LS2 )
    work
    SPC( pc-high )
  UNTIL( pc-high )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR P1
  DEVICE MC1 EVENT tick EVERY 1000 ms
  TIME look : 44 ms
  TIME see : 31 ms
  TIME work : 5 ms
  PLACE LS1 ON P0 PRIORITY 2
  PLACE SM1 ON P0 PRIORITY 1
  PLACE LS2 ON P1 PRIORITY 1
END ENVIRONMENT
)");
  // LS1 runs before the second request, and counts once more before the work.
  CHECK(found.compositional == Duration(93 * ms));
  CHECK(found.exact == Duration(80 * ms));
  CHECK(found.addends == 93 * ms);
}
