// PAL0820: what events ask of a processor is never told too high.
#include <catch2/catch.hpp>

#include "tests/support/skill.hpp"
#include "tests/unit/analyzer/small_skill.hpp"

using namespace pal;
using test::small_skill;

namespace {

/// What is said of a skill method with `round` as the body of its loop. Each activity takes 6 ms. Each tick
/// and each stop comes every 10 ms.
std::string said(const std::string& round) {
  const auto has = [&round](const std::string& what) { return round.find(what) != std::string::npos; };
  const std::string loop = "\nSkill Module: SM1\n  ACTIVITY work\nBEGIN\n  WTM( Coordinator )\n  REPEAT\n" +
                           round +
                           "\n    SPC( pc-high )\n  UNTIL( pc-high )\n  TXM( Completion Protocol 0 )\nEND\n";
  const std::string environment =
      std::string("PROCESSOR P0\nPLACE SM1 ON P0 PRIORITY 1\nTIME work : 6 ms\n") +
      "COST RECEIVE 1 ms\nDEVICE MC1 EVENT tick EVERY 10 ms\n" +
      (has("MC2") ? "DEVICE MC2 EVENT stop EVERY 10 ms\n" : "") +
      (has("LS1") ? "DEVICE LS1 ON REQUEST 1 ms\n" : "");
  const auto skill = test::skill_from_text(small_skill("", loop, environment));
  INFO(test::messages(skill->diagnostics));
  REQUIRE(skill->problem);
  const std::string messages = test::messages(skill->diagnostics);
  const auto found = messages.find("PAL0820");
  return found == std::string::npos ? "" : messages.substr(found, messages.find('\n', found) - found);
}

}  // namespace

TEST_CASE("a round that takes two events has two periods for its work") {
  CHECK(said("WTM( tick from MC1 )\nwork\nWTM( tick from MC1 )\nwork") == "");
  CHECK(said("WTM( tick from MC1 )\nwork\nwork").find("140.0 %") == std::string::npos);
  CHECK(said("WTM( tick from MC1 )\nwork\nwork").find("130.0 %") != std::string::npos);
}

TEST_CASE("the work between two kinds of events counts once") {
  CHECK(said("WTM( tick from MC1 )\nDo Nothing\nWTM( stop from MC2 )\nwork") == "");
}

TEST_CASE("a wait that gives up counts with its test alone") {
  // 1 ms for the tick, 6 of work, 1 or 0 at the second wait.
  const std::string look =
      "TXM( request value to LS1 )\nWTM( value from LS1 ) WITHIN 1 ms\nDo Nothing\nELSE\nDo Nothing\nEND "
      "WTM\n";
  CHECK(said("WTM( tick from MC1 )\nwork\n" + look + "work").find("130.0 %") != std::string::npos);
}
