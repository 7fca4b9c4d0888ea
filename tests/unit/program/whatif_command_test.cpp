#include "tests/unit/program/program.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "programs/pal/reports/whatif_answer.hpp"
#include "tests/unit/whatif/two_chains.hpp"

using namespace pal::test;
using pal::program::ExitStatus;

namespace {

const std::string places = std::string(PAL_SOURCE_DIR) + "/tests/reference/figure_3_6_places.pal";

bool says(const Answer& answer, const std::string& text) {
  return answer.out.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("slack: fails as things are, not known, not looked for") {
  // It ends by itself. A machine that is busy has time enough.
  const Answer fails = pal::test::pal({"whatif", read_first, "-e", cell, "--timeout", "10min"});
  CHECK(fails.status == ExitStatus::not_met);
  CHECK(says(fails, "'fresh-force' does not hold as things are, so no worst time may grow."));
  CHECK_FALSE(says(fails, "may grow by"));
  CHECK(says(fails, "'fresh-force', 10 ms allowed: before fails 35.35 ms, after holds 7.3 ms"));

  // Ended before anything was decided: nothing is said to fail.
  const Answer ended = pal::test::pal({"whatif", touch, "-e", cell, "--timeout", "1ns"});
  CHECK(ended.status == ExitStatus::not_met);
  CHECK(says(ended, "not known"));
  CHECK(says(ended, "is undecided as things are"));
  CHECK_FALSE(says(ended, "does not hold"));
}

TEST_CASE("a remedy of the environment is said in words and as options") {
  const std::string example = std::string(PAL_SOURCE_DIR) + "/examples/two_processors/";
  const Answer answer =
      pal::test::pal({"whatif", example + "two_processors.pal", "-e", example + "one_processor.pal"});
  CHECK(answer.status == ExitStatus::not_met);
  CHECK(says(answer,
             "1. add processor P1 and place SM1 on P1: --set 'PROCESSOR P1' --set 'SM1.processor = P1'"));
  CHECK(says(answer,
             "'answer', 1 ms allowed: before fails 6 ms, after holds 0 ms\n"
             "       2 other requirements hold as before"));
}

TEST_CASE("shorter times are said by requirement, as text and as JSON") {
  const pal::MemoryFileSystem files = in_memory(two_chains("6 ms"));
  const Answer text = pal::test::pal({"whatif", "s.pal"}, files);
  CHECK(text.status == ExitStatus::not_met);
  CHECK(says(text,
             "  'soon' holds with one time shorter; each of these suffices:\n"
             "       answer OF SM1: 0 TO 1 ms instead of 2 ms: --set 'answer OF SM1 = 0 TO 1 ms'\n"
             "       heavy OF LS1: 0 TO 4 ms instead of 5 ms: --set 'heavy OF LS1 = 0 TO 4 ms'\n"));
  const Answer made = pal::test::pal({"whatif", "s.pal", "--set", "heavy OF LS1 = 0 TO 4 ms"}, files);
  CHECK(made.status == ExitStatus::all_hold);

  const Answer json = pal::test::pal({"whatif", "s.pal", "--format", "json"}, files);
  const auto remedies = nlohmann::json::parse(json.out).at("what_if").at(0).at("remedies");
  REQUIRE(remedies.at("short_enough").size() == 2);
  const auto& heavy = remedies.at("short_enough").at(1);
  CHECK(heavy.at("requirement") == "soon");
  CHECK(heavy.at("figure") == "heavy OF LS1");
  CHECK(heavy.at("best_ns") == 5'000'000);
  CHECK(heavy.at("worst_ns") == 5'000'000);
  CHECK(heavy.at("enough_best_ns") == 0);
  CHECK(heavy.at("enough_worst_ns") == 4'000'000);
}

TEST_CASE("a specification with errors is refused before anything is looked for") {
  const std::string file = std::string(PAL_SOURCE_DIR) + "/tests/golden/check/fail_shared_message.pal";
  std::ostringstream out, err;
  const pal::DiskFileSystem files;
  // On a terminal the table begins as soon as slacks are looked for.
  CHECK(pal::program::run({"whatif", file}, {out, err, files, true}) == ExitStatus::wrong_specification);
  CHECK(out.str().empty());
  CHECK(err.str().find("PAL0732") != std::string::npos);
}

TEST_CASE("the fewest processors are claimed only for the priorities that were tried") {
  const Answer kept = pal::test::pal({"whatif", places, "--environment-name", "reading", "--place", "0"});
  CHECK(says(kept, "2 processors do; with the priorities as they are fewer do not: each placement"));
  const Answer all =
      pal::test::pal({"whatif", places, "--environment-name", "reading", "--place", "0", "--priorities"});
  CHECK(says(all, "2 processors do; fewer do not: each placement"));
}

TEST_CASE("a wrong value of an option is refused with the allowed ones") {
  expect_refused({"check", touch, "--format", "xml"}, "'xml' is none of json, junit, sarif, text");
  expect_refused({"check", touch, "--format", "1"}, "'1' is none of json, junit, sarif, text");
  expect_refused({"check", touch, "--analysis", "long"}, "'long' is none of auto, compositional, exact");
  expect_refused({"check", touch, "--max-states", "-1"}, "'-1' is not a whole number from 0 on");
  expect_refused({"check", touch, "--threads", "many"}, "'many' is not a whole number from 0 on");
  expect_refused({"check", touch, "--threads", "1001"}, "1001 not in range 0 to 1000");
  expect_refused({"check", touch, "--max-errors", "-1"}, "'-1' is not a whole number from 0 on");
  expect_refused({"simulate", touch, "-e", cell, "--seed", "-1"}, "'-1' is not a whole number from 0 on");
  expect_refused({"simulate", touch, "-e", cell, "--until", "4000000001 s"},
                 "a run is no longer than 4000000000 s");
  expect_refused({"simulate", touch, "-e", cell, "--seed", "18446744073709551616"}, "of 64 bits");
  expect_refused({"simulate", touch, "-e", cell, "--times", "odd"},
                 "'odd' is none of best, extremes, random, worst");
}

namespace {

/// Two drivers share P0. Its load reaches 100 % where w takes 50/7 ms, v 4.9 ms, or each take 29/17 ms more.
const std::string two_drivers = text_of("two_drivers");

}  // namespace

TEST_CASE("a slack is found although a growth leaves no time for all") {
  const pal::MemoryFileSystem files = in_memory(two_drivers);
  const Answer answer = pal::test::pal({"whatif", "s.pal", "--timeout", "10min", "--format", "json"}, files);
  INFO(answer.out);
  CHECK(answer.status == ExitStatus::all_hold);
  const auto slack = nlohmann::json::parse(answer.out).at("what_if").at(0).at("slack");
  const auto row = [&](const std::string& name) {
    for (const auto& each : slack) {
      if (each.at("figure") == name) return each;
    }
    FAIL(name << " is missing");
    return slack.at(0);
  };
  // With work of 7 ms in 10 and of 2 in 7 the processor does not pause in 50 ms.
  CHECK(row("w OF MC1").at("holds_with_growth_ns") == 3'999'999);
  CHECK(row("w OF MC1").at("fails_with_growth_ns") == 4'000'000);
  CHECK(row("RECEIVE").at("exact") == true);
  CHECK(row("a OF SM1").at("unlimited") == true);
}

TEST_CASE("every command refuses an environment that lacks what the skill needs") {
  const std::string lacking = std::string(PAL_SOURCE_DIR) + "/tests/golden/check/fail_not_listed.pal";
  for (const char* command : {"check", "whatif", "simulate", "atc", "generate"}) {
    const Answer answer = pal::test::pal({command, lacking});
    INFO(command);
    CHECK(answer.status == ExitStatus::wrong_specification);
    CHECK(answer.err.find("PAL0740") != std::string::npos);
  }
}

TEST_CASE("every command that uses times reports a loop in which no time passes") {
  std::string text = two_drivers;
  const std::string time = "a OF SM1 : 50 ms";
  text.replace(text.find(time), time.size(), "a OF SM1 : 0 ms");
  const pal::MemoryFileSystem files = in_memory(text);
  const std::vector<std::vector<std::string>> commands{{"check", "s.pal"},
                                                       {"whatif", "s.pal"},
                                                       {"whatif", "s.pal", "--place", "1"},
                                                       {"whatif", "s.pal", "--set", "v OF MC2 = 1 ms"},
                                                       {"simulate", "s.pal", "--timeout", "1s"},
                                                       {"atc", "s.pal"}};
  for (const std::vector<std::string>& command : commands) {
    const Answer answer = pal::test::pal(command, files);
    INFO(command.front() << answer.err);
    CHECK(answer.status != ExitStatus::all_hold);
    CHECK(answer.status != ExitStatus::wrong_specification);
    CHECK(answer.err.find("PAL0821") != std::string::npos);
  }
  // With a time it is none.
  const Answer mended = pal::test::pal({"whatif", "s.pal", "--set", "a OF SM1 = 1 ms"}, files);
  CHECK(mended.err.find("PAL0821") == std::string::npos);
}

TEST_CASE("an impossible time is one error, without a second one about its interval") {
  for (const char* time : {"1 TO -3 ms", "1 TO 9223372036854775808 ns", "1 TO 1.5 ns"}) {
    std::string text = two_drivers;
    const std::string before = "w OF MC1 : 1 TO 3 ms";
    text.replace(text.find(before), before.size(), std::string("w OF MC1 : ") + time);
    const pal::MemoryFileSystem files = in_memory(text);
    const Answer answer = pal::test::pal({"check", "s.pal"}, files);
    INFO(answer.err);
    CHECK(answer.status == ExitStatus::wrong_specification);
    CHECK(answer.err.find("PAL0705") == std::string::npos);
    CHECK(answer.err.find("1 error") != std::string::npos);
  }
}

TEST_CASE("changed figures are refused as written ones are, and activities found by any name") {
  std::string text = two_drivers;
  for (std::size_t at = 0; (at = text.find(" w", at)) != std::string::npos;) {
    if (text[at + 2] == ' ' || text[at + 2] == '\n') text.replace(at, 2, " SEND");
    ++at;
  }
  const pal::MemoryFileSystem files = in_memory(text);
  const auto with = [&](const std::string& change) {
    return pal::test::pal({"whatif", "s.pal", "--set", change, "--timeout", "20s"}, files);
  };
  CHECK(with("d1.phase = 9 ms").status == ExitStatus::all_hold);
  CHECK(with("d1.phase = 10 ms").err.find("PAL0709") != std::string::npos);
  CHECK(with("d1.jitter = 10 ms").err.find("PAL0726") != std::string::npos);
  CHECK(with("d1.period = 0 ms").err.find("PAL0708") != std::string::npos);
  CHECK(with("SEND OF MC1 = 3 TO 1 ms").status == ExitStatus::usage);

  CHECK(says(with("SEND = 4 ms"), "holds              5 ms    holds              5 ms"));
  for (const char* name : {"SEND OF MC1", "ACTIVITY SEND"}) {
    CHECK(says(with(std::string(name) + " = 4 ms"), "holds              5 ms    holds              6 ms"));
  }
}

TEST_CASE("a processor that a placement adds has a name of its own") {
  std::string text = two_drivers;
  text.replace(text.find("  PROCESSOR P0\n"), 15, "");
  for (std::size_t at = 0; (at = text.find("P0", at)) != std::string::npos;) text.replace(at, 2, "P1");
  const pal::MemoryFileSystem files = in_memory(text);
  const Answer answer = pal::test::pal({"whatif", "s.pal", "--place", "2", "--timeout", "20s"}, files);
  INFO(answer.out);
  CHECK(says(answer, "P1: "));
  CHECK(says(answer, "; P2: "));
  CHECK_FALSE(says(answer, "; P1: "));
  const Answer many = pal::test::pal({"whatif", "s.pal", "--place", "4"}, files);
  CHECK(many.status == ExitStatus::not_met);
  CHECK(says(many, "4 processors: more than there are threads to place"));
}

TEST_CASE("the slack of all together is told as a part of the longest time") {
  pal::program::WhatIfAnswer answer;
  answer.requirements = {"r"};
  pal::analyzer::whatif::Slack slack;
  slack.time = {pal::Duration(2), pal::Duration(2)};
  slack.holds = pal::Duration(1);
  slack.fails = pal::Duration(2);
  slack.requirement = pal::analyzer::RequirementId(0);
  answer.slacks = {slack};
  CHECK(text(answer).find(" 50.0 %  then 'r' fails") != std::string::npos);
}

// P0 is busy for 10 ms, and then at one instant for ever: that has no end, and is not measured.
TEST_CASE("no run breaks a limit by a busy period in which time stands still") {
  const pal::MemoryFileSystem files = in_memory(text_of("busy_till_time_stands_still"));
  CHECK(says(pal::test::pal({"check", "s.pal"}, files), "undecided  b"));
  const Answer slack = pal::test::pal({"whatif", "s.pal"}, files);
  CHECK(slack.status == ExitStatus::not_met);
  CHECK(says(slack, "'b' is undecided as things are"));
  CHECK(says(pal::test::pal({"whatif", "s.pal", "--place", "1"}, files), "0 refuted, 1 undecided"));
  const Answer other = pal::test::pal({"whatif", "s.pal", "--set", "work = 1 ms"}, files);
  CHECK(other.status == ExitStatus::not_met);
  CHECK_FALSE(says(other, "holds"));
  CHECK_FALSE(says(other, "fails"));
  const Answer runs = pal::test::pal({"simulate", "s.pal", "--runs", "3"}, files);
  CHECK(runs.status == ExitStatus::not_met);
  CHECK(says(runs, "open      b"));
}
