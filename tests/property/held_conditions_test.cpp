// In a slice a condition keeps its value while no thread that sets it can run (docs/internals/slices.md).
#include <catch2/catch.hpp>
#include <string>

#include "analyzer/exact/cap.hpp"
#include "analyzer/exact/slice_bound.hpp"
#include "analyzer/slice/slice.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

const std::string ask_between =
    "      TXM( request value from Reckoner )\n      WTM( value from Reckoner )\n";

const std::string reckoner_module = R"(
Logical Sensor: Reckoner
  RETURNS value
  ACTIVITY reckon WRITES value
BEGIN
  REPEAT
    WTM( request value from Method )
    reckon
    TXM( value to Method )
  UNTIL( forever )
END
)";

/// Block 1 sets a condition, block 2 reads it twice. If both reads give the same value, a round takes the
/// same time whatever they give.
struct Shape {
  std::string gap;           // statements between the two reads
  std::string setter;        // where block 1 runs
  std::string reckoner;      // where the server runs that block 2 asks between the reads, if it asks
  bool preemptive = true;    // the processor of block 2
  bool also_before = false;  // the method itself sets the condition, too
};

std::string text_of(const Shape& shape) {
  const bool asks = shape.gap == ask_between;
  return R"(
DEVICE alter

MESSAGE push       : REAL N
MESSAGE motion     : REAL mm
MESSAGE correction : REAL mm
MESSAGE tick       : SIGNAL
)" + std::string(asks ? "MESSAGE value : REAL mm\n" : "") +
         R"(
CONDITION hot
CONDITION arrived

SKILL hold
)" + std::string(asks ? "  LOGICAL SENSOR     Push, Reckoner\n" : "  LOGICAL SENSOR     Push\n") +
         R"(  MACHINE CONTROLLER Alter
  SKILL METHOD       Method
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT steady : INTERVAL OF TXM( motion to Alter ) AT MOST 20 ms
END SKILL

Logical Sensor: Push
  RETURNS push
  ACTIVITY extract WRITES push
BEGIN
  REPEAT
    WTM( request push from Method )
    extract
    TXM( push to Method )
  UNTIL( forever )
END

)" + (asks ? reckoner_module : "") +
         R"(
Machine Controller: Alter
BEGIN
  REPEAT
    WTM( tick from alter )
    TXM( request motion from Method )
    WTM( motion from Method )
    TXM( correction to alter )
  UNTIL( forever )
END

Skill Module: Method
  ACTIVITY quick WRITES motion
  ACTIVITY slow  WRITES motion
  ACTIVITY gap
BEGIN
  WTM( Coordinator )
)" + std::string(shape.also_before ? "  SPC( hot )\n" : "") +
         R"(  CONCURRENT
  BEGIN
    REPEAT
      TXM( request push from Push )
      WTM( push from Push )
      SPC( hot )
    UNTIL( forever )
  END
  BEGIN
    REPEAT
      WTM( motion request from Alter )
      RPC( hot )
      CASE
        ( hot ):
          slow
        ( NOT hot ):
          quick
      END CASE
)" + shape.gap +
         R"(      RPC( hot )
      CASE
        ( hot ):
          quick
        ( NOT hot ):
          slow
      END CASE
      TXM( motion to Alter )
      SPC( arrived )
    UNTIL( arrived )
  END
  END CONCURRENT
  WTM( motion request from Alter )
  TXM( Completion Protocol 0 )
END

ENVIRONMENT held
  PROCESSOR P0)" +
         (shape.preemptive ? "" : " NONPREEMPTIVE") + R"(
  PROCESSOR P1
  PROCESSOR P2
  PLACE Alter ON P1 PRIORITY 3
  PLACE Push ON P2 PRIORITY 2
)" + (asks ? "  PLACE Reckoner ON " + shape.reckoner + "\n  TIME reckon : 0.5 ms\n" : "") +
         R"(  PLACE Method ON P0 PRIORITY 2
  PLACE Method.1 ON )" +
         shape.setter + R"(
  PLACE Method.2 ON P0 PRIORITY 2
  DEVICE alter EVENT tick EVERY 14 ms
  TIME extract : 2 TO 3 ms
  TIME quick : 1 ms
  TIME slow : 3 ms
  TIME gap : 0.5 ms
  COST SEND 0 ms
  COST RECEIVE 0 ms
  COST SET 0 ms
  COST READ 0 ms
  COST TEST 0 ms
  LATENCY BETWEEN PROCESSORS 0 TO 0 ms
END ENVIRONMENT
)";
}

Nanoseconds bound_of(const Problem& slice, const Requirement& requirement) {
  Limits limits;
  limits.classes = 100'000;
  const SliceBound found = bound_in(slice, requirement, cap_of(slice, requirement.limit), limits);
  REQUIRE(found.bound);
  return *found.bound;
}

struct Bounds {
  Nanoseconds exact = 0;  // of all runs of the whole skill
  Nanoseconds held = 0;   // of a slice
  Nanoseconds free = 0;   // of the same, if each read gives any value
};

Bounds bounds_of(const Shape& shape) {
  const auto skill = test::sound_skill(text_of(shape));
  const Problem& problem = *skill->problem;
  const Requirement& requirement = problem.requirements.front();
  const Verdict exact = analyze_exactly(problem, {}).verdicts.front();
  REQUIRE(exact.exact);
  Problem slice = slice_of(problem, cone_of(problem, requirement), {true, false});
  Bounds bounds;
  bounds.exact = exact.bound->count();
  bounds.held = bound_of(slice, requirement);
  slice.setters.clear();
  bounds.free = bound_of(slice, requirement);
  return bounds;
}

}  // namespace

TEST_CASE("what a condition keeps in a slice it keeps in all runs of the skill") {
  const std::string work = "      gap\n";
  std::size_t nearer = 0;   // than if the condition kept nothing
  std::size_t changes = 0;  // in some run it changes between the reads
  for (const std::string& gap : {std::string(), work, ask_between}) {
    for (const std::string setter : {"P0 PRIORITY 1", "P0 PRIORITY 2", "P0 PRIORITY 3", "P2 PRIORITY 1"}) {
      for (const std::string reckoner : {"P0 PRIORITY 4", "P0 PRIORITY 1", "P1 PRIORITY 1"}) {
        if (gap != ask_between && reckoner != "P0 PRIORITY 4") continue;
        for (const bool preemptive : {false, true}) {
          for (const bool also_before : {false, true}) {
            INFO("between the reads:\n"
                 << gap << "setter " << setter << ", reckoner " << reckoner
                 << (preemptive ? "" : ", nonpreemptive") << (also_before ? ", set before" : ""));
            const Bounds bounds = bounds_of({gap, setter, reckoner, preemptive, also_before});
            INFO("exact " << bounds.exact << ", held " << bounds.held << ", free " << bounds.free);
            REQUIRE(bounds.exact <= bounds.held);
            REQUIRE(bounds.held <= bounds.free);
            nearer += bounds.held < bounds.free ? 1 : 0;
            changes += bounds.exact == bounds.free ? 1 : 0;
          }
        }
      }
    }
  }
  CHECK(nearer >= 20);
  CHECK(changes >= 30);
}

TEST_CASE("a condition is kept while its processor is busy with others") {
  const Bounds bounds = bounds_of({"      gap\n", "P0 PRIORITY 1", "P1 PRIORITY 1"});
  CHECK(bounds.exact == 14'000'000);
  CHECK(bounds.held == bounds.exact);
  CHECK(bounds.free == 18'000'000);
}
