#include "analyzer/problem/problem.hpp"

#include <catch2/catch.hpp>
#include <functional>

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

TEST_CASE("impossible times are findings, each with a code") {
  const std::string place = "PROCESSOR P0\nPLACE SM1 ON P0 PRIORITY 1\n";
  const auto with = [&](const std::string& device, const std::string& work) {
    return codes(small_skill("", worker, place + "DEVICE MC1 " + device + "\nTIME work : " + work + "\n"));
  };
  CHECK(with("EVENT tick EVERY 10 ms", "1 ms") == "");
  CHECK(with("EVENT tick EVERY 0 ms", "1 ms") == "PAL0708 ");
  CHECK(with("EVENT tick SPORADIC 0 ms", "1 ms") == "PAL0708 ");
  CHECK(with("FRAMES EVERY 0 ms COLLECTING 0 ms", "1 ms").find("PAL0708 ") == 0);
  CHECK(with("EVENT tick EVERY 10 ms PHASE 11 ms", "1 ms") == "PAL0709 ");
  CHECK(with("EVENT tick EVERY 10 ms", "3 TO 1 ms") == "PAL0705 ");
  CHECK(with("EVENT tick EVERY 10 ms", "-1 ms").find("PAL0701 ") == 0);
  CHECK(with("EVENT tick EVERY 10 ms", "9223372036 s") == "PAL0704 PAL0704 ");
  CHECK(with("EVENT tick EVERY 10 ms", "9223372037 s").find("PAL0704 ") == 0);
  CHECK(with("EVENT tick EVERY 9223372036 s", "1 ms").find("PAL0704 ") == 0);
}

TEST_CASE("a processor with more work than time is a warning that names the threads") {
  const auto skill =
      test::skill_from_text(small_skill("", worker,
                                        "PROCESSOR P0\nDEVICE MC1 EVENT tick EVERY 10 ms\nTIME work : 5 TO "
                                        "12 ms\nPLACE SM1 ON P0 PRIORITY 1\n"));
  REQUIRE(skill->problem);
  CHECK(test::messages(skill->diagnostics)
            .find("PAL0820 processor P0 has more work than time when events come as "
                  "often as they may: 120.0 % (SM1 120.0 % for tick)") != std::string::npos);
}

TEST_CASE("a loop in which nothing happens is refused") {
  CHECK(codes(small_skill("", R"(
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  REPEAT
    Do Nothing
  UNTIL( forever )
END
)",
                          "PROCESSOR P0\nPLACE SM1 ON P0 PRIORITY 1\n")) != "");
}

TEST_CASE("the load of an unknown processor is refused") {
  CHECK(codes(small_skill("REQUIREMENT load : LOAD OF P7 AT MOST 50 %", worker, good_environment)) ==
        "PAL0813 ");
}

TEST_CASE("an activity may take another time in another module") {
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

TEST_CASE("figures of an environment that no text has are told") {
  const auto skill = test::skill_from_text(small_skill("", worker, good_environment));
  const auto told = [&](const std::function<void(pan::Environment&)>& change) {
    pan::Environment environment = skill->specification.environments.front();
    change(environment);
    Diagnostics diagnostics;
    CHECK_FALSE(make_problem(skill->specification.skills.front(), environment, diagnostics, &skill->sources));
    return diagnostics.all().front().message;
  };
  const auto time = [&](Duration best, Duration worst) {
    return told([&](pan::Environment& environment) { environment.activities.front().time = {best, worst}; });
  };
  const auto ms = [](int count) { return Duration(count * 1'000'000); };
  CHECK(time(ms(-1), ms(1)) == "the time of activity work is negative");
  CHECK(time(ms(2), ms(1)) == "the best time of activity work is longer than its worst");
  CHECK(time(ms(1), Duration(2'000'000'000'000'000'000)) ==
        "the time of activity work is too long to reckon with");
  const auto device = [&](const std::function<void(pan::EventDevice&)>& change) {
    return told([&](pan::Environment& environment) {
      change(std::get<pan::EventDevice>(environment.devices.front().behaviour));
    });
  };
  CHECK(device([](pan::EventDevice& event) { event.period = {}; }) ==
        "the time of the period of MC1 is zero");
  CHECK(device([&](pan::EventDevice& event) { event.phase = event.period; }) ==
        "the phase of MC1 is not below its period");
  CHECK(told([&](pan::Environment& environment) {
          environment.devices.front().behaviour = pan::FrameDevice{ms(1), ms(2), {}};
        }) == "MC1 collects a frame for longer than its period");
}

TEST_CASE("modules that execute one another too deep are told") {
  std::string slots;
  std::string modules;
  for (int i = 1; i <= 40; ++i) {
    const std::string n = std::to_string(i);
    slots += "CONTINGENCY " + n + " \"it is dark\" METHOD CM" + n + "\n";
    const std::string next = i == 40 ? "Do Nothing" : "Execute CM" + std::to_string(i + 1);
    modules += "Contingency Module: CM" + n + "\nBEGIN\n" + next + "\nEND\n";
  }
  const std::string caller = worker;
  const auto execute = caller.substr(0, caller.find("    work")) + "    Execute CM1\n" +
                       caller.substr(caller.find("    work"));
  const auto skill = test::skill_from_text(small_skill(slots, execute + modules, good_environment));
  CHECK(test::messages(skill->diagnostics).find("PAL0730 modules execute one another more than 32 deep\n") !=
        std::string::npos);
}
