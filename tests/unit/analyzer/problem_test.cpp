#include "analyzer/problem.hpp"

#include <catch2/catch.hpp>

#include "pal/support/diagnostic_code.hpp"
#include "tests/support/skill.hpp"
#include "tests/unit/analyzer/small_skill.hpp"

using namespace pal;
using test::small_skill;
using test::worker;

namespace {

/// The codes that making the problem reports.
std::string codes(const std::string& text) {
  const auto skill = test::skill_from_text(text);
  std::string found;
  for (const Diagnostic& each : skill->diagnostics.all()) {
    if (each.severity != Severity::error) continue;
    found += std::string(name(each.code)) + " ";
    CHECK_FALSE(each.message.empty());
  }
  CHECK(found.empty() == skill->problem.has_value());
  return found;
}

const std::string good_environment =
    "PROCESSOR P0\nDEVICE MC1 EVENT tick EVERY 10 ms\nTIME work : 1 ms\nPLACE SM1 ON P0 PRIORITY 1\n";

}  // namespace

TEST_CASE("a sound skill in a sound environment is a problem") {
  CHECK(codes(small_skill("", worker, good_environment)).empty());
}

TEST_CASE("an environment must place every module") {
  CHECK(
      codes(small_skill("", worker, "PROCESSOR P0\nDEVICE MC1 EVENT tick EVERY 10 ms\nTIME work : 1 ms\n")) ==
      "PAL0721 ");
}

TEST_CASE("an environment must time every activity") {
  CHECK(codes(small_skill("", worker,
                          "PROCESSOR P0\nDEVICE MC1 EVENT tick EVERY 10 ms\nPLACE SM1 ON P0 PRIORITY 1\n")) ==
        "PAL0725 ");
}

TEST_CASE("a module without a body needs a device") {
  CHECK(codes(small_skill("", worker, "PROCESSOR P0\nTIME work : 1 ms\nPLACE SM1 ON P0 PRIORITY 1\n")) ==
        "PAL0724 ");
}

TEST_CASE("a device must send what the skill waits for") {
  CHECK(codes(small_skill("", worker,
                          "PROCESSOR P0\nDEVICE MC1 EVENT stop EVERY 10 ms\nTIME work : 1 ms\nPLACE SM1 ON "
                          "P0 PRIORITY 1\n")) == "PAL0727 PAL0727 ");
}

TEST_CASE("jitter must be shorter than the period") {
  CHECK(codes(small_skill("", worker,
                          "PROCESSOR P0\nDEVICE MC1 EVENT tick EVERY 10 ms JITTER 10 ms\nTIME work : 1 "
                          "ms\nPLACE SM1 ON P0 PRIORITY 1\n")) == "PAL0726 ");
}

TEST_CASE("a load of a processor that is not there is refused") {
  CHECK(codes(small_skill("REQUIREMENT load : LOAD OF P7 AT MOST 50 %", worker, good_environment)) ==
        "PAL0813 ");
}

TEST_CASE("what an activity takes on one module may differ from elsewhere") {
  const auto skill =
      test::sound_skill(small_skill("", worker, good_environment + "TIME work OF SM1 : 3 ms\n"));
  bool found = false;
  for (const analyzer::Step& step : skill->problem->steps) {
    if (step.kind == analyzer::Step::Kind::activity) {
      CHECK(step.cost == analyzer::Range{3'000'000, 3'000'000});
      found = true;
    }
  }
  CHECK(found);
}
