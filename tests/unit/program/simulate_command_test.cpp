// pal simulate: random runs and runs by script.
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "programs/pal/session/runs.hpp"
#include "programs/pal/session/survey.hpp"
#include "tests/support/skill.hpp"
#include "tests/unit/program/program.hpp"

using namespace pal::test;
using pal::program::ExitStatus;
using OrderedJson = nlohmann::ordered_json;

namespace {

OrderedJson simulated(std::vector<std::string> arguments, ExitStatus status) {
  arguments.insert(arguments.begin(), "simulate");
  for (const char* more : {"-e", cell.c_str(), "--format", "json"}) arguments.emplace_back(more);
  const Answer answer = pal::test::pal(arguments);
  INFO(answer.err);
  CHECK(answer.status == status);
  return OrderedJson::parse(answer.out).at("simulations").at(0);
}

OrderedJson requirement(const OrderedJson& simulation, const std::string& name) {
  for (const OrderedJson& row : simulation.at("requirements")) {
    if (row.at("name") == name) return row;
  }
  FAIL("no requirement " << name);
  return {};
}

std::string temporary(const std::string& name) {
  return (std::filesystem::temp_directory_path() / own_name(name)).string();
}

}  // namespace

TEST_CASE("runs by chance keep what is proved, and break what is refuted") {
  const OrderedJson kept = simulated({touch}, ExitStatus::all_hold);
  CHECK(kept.at("runs") == 100);
  CHECK(kept.at("completed") == 100);
  CHECK(requirement(kept, "fresh-force").at("extreme_ns") <= 7'300'000);
  CHECK(requirement(kept, "fresh-force").at("values") > 30);
  CHECK(requirement(kept, "headroom").at("extreme_ns") > 0);

  const OrderedJson broken = simulated({read_first}, ExitStatus::not_met);
  const OrderedJson fresh = requirement(broken, "fresh-force");
  CHECK(fresh.at("broken_runs") > 10);
  CHECK(fresh.at("extreme_ns") > 10'000'000);
  CHECK(fresh.at("extreme_ns") <= 35'350'000);
  CHECK(requirement(broken, "answer-alter").at("broken_runs") == 0);
}

TEST_CASE("the same seed gives the same run, and the named run shows the value") {
  const OrderedJson all = simulated({read_first}, ExitStatus::not_met);
  const OrderedJson fresh = requirement(all, "fresh-force");
  const std::string seed = fresh.at("run").get<std::string>().substr(std::string("seed ").size());
  const OrderedJson one = simulated({read_first, "--seed", seed, "--runs", "1"}, ExitStatus::not_met);
  CHECK(one.at("runs") == 1);
  CHECK(requirement(one, "fresh-force").at("extreme_ns") == fresh.at("extreme_ns"));
}

TEST_CASE("every witness can be made again from its script alone, and shows the bound") {
  const std::string file = temporary("simulate_script");
  CHECK(pal::test::pal({"check", read_first, "-e", cell, "--witness", file}).status == ExitStatus::not_met);
  const OrderedJson made = simulated({read_first, "--script", file}, ExitStatus::not_met);
  CHECK(made.at("runs") == 4);
  CHECK(made.at("refused").empty());
  CHECK(requirement(made, "fresh-force").at("extreme_ns") == 35'350'000);
  CHECK(requirement(made, "answer-alter").at("extreme_ns") == 4'400'000);

  // The events are not looked at: without them it is the same run.
  OrderedJson witnesses = [&] {
    std::ifstream in(file);
    return OrderedJson::parse(in);
  }();
  OrderedJson bare = witnesses;
  for (OrderedJson& witness : bare.at("witnesses")) witness.at("run").at("events") = OrderedJson::array();
  std::ofstream(file) << bare;
  CHECK(simulated({read_first, "--script", file}, ExitStatus::not_met) == made);

  // A script that fires earlier than anything can.
  for (OrderedJson& firing : witnesses.at("witnesses").at(1).at("script")) firing.at("at_ns") = 0;
  std::ofstream(file) << witnesses;
  const OrderedJson refused = simulated({read_first, "--script", file}, ExitStatus::not_met).at("refused");
  REQUIRE(refused.size() == 1);
  CHECK(refused.at(0) == "the script of fresh-force: its script cannot be followed");

  CHECK(pal::test::pal({"simulate", touch, "-e", cell, "--script", file}).status == ExitStatus::usage);
  std::filesystem::remove(file);
}

TEST_CASE("a run that is written shows the value that is reported") {
  const std::string trace = temporary("simulate_trace");
  const std::string chart = temporary("simulate_chart");
  const Answer answer = pal::test::pal(
      {"simulate", read_first, "-e", cell, "-r", "fresh-force", "--trace", trace, "--chart", chart});
  CHECK(answer.status == ExitStatus::not_met);
  std::stringstream drawn;
  drawn << std::ifstream(chart).rdbuf();
  CHECK(drawn.str().find("touch-read-first in workcell: fresh-force broken") != std::string::npos);
  CHECK(std::filesystem::file_size(trace) > 1'000);
  std::filesystem::remove(trace);
  std::filesystem::remove(chart);
}

TEST_CASE("a skill that cannot be simulated is reported") {
  expect_refused({"simulate", touch}, "give an environment with --environment FILE");
  expect_refused({"simulate", touch, "-e", cell, "--runs", "0"}, "--runs");
  expect_refused({"simulate", touch, "-e", cell, "--until", "soon"}, "no length of time");
  expect_refused({"simulate", touch, "-e", cell, "--script", "/nowhere.json"}, "cannot read '/nowhere.json'");
  expect_refused({"simulate", touch, "-e", cell, "--script", touch}, "is no file of witnesses");
  expect_refused({"simulate", touch, "-e", cell, "-r", "fresh"},
                 "no requirement is called 'fresh'; there is 'answer-alter'");
  expect_refused({"simulate", touch, "-e", cell, "--until", "0", "-r", "answer-alter", "--trace", "/tmp/x"},
                 "no run shows a value of 'answer-alter'");
  expect_refused({"simulate", cell}, "there is no skill to simulate");
}

namespace {

/// The skill ends after 50 ms; MC1 answers the event of 4 ms after 84.
const std::string ends_before_the_answer = text_of("ends_before_the_answer");

/// LS1 does not wait for the second request, so that nothing happens any more once it has come.
const std::string stands_still = text_of("stands_still");

/// Each time that MC1 is done its next event is there.
const std::string never_idle = text_of("never_idle");

OrderedJson simulated(const std::string& text, const std::string& until, ExitStatus status) {
  const Answer answer = pal::test::pal(
      {"simulate", "s.pal", "--until", until, "--runs", "5", "--format", "json"}, in_memory(text));
  INFO(answer.err);
  CHECK(answer.status == status);
  return OrderedJson::parse(answer.out).at("simulations").at(0);
}

}  // namespace

TEST_CASE("a run that is cut off breaks nothing by values that need not count") {
  const pal::MemoryFileSystem files = in_memory(ends_before_the_answer);
  CHECK(pal::test::pal({"check", "s.pal"}, files).out.find("  never      x") != std::string::npos);

  const OrderedJson cut = simulated(ends_before_the_answer, "20ms", ExitStatus::not_met);
  CHECK(requirement(cut, "x").at("broken_runs") == 0);
  CHECK(requirement(cut, "x").at("open_runs") == 5);
  CHECK(requirement(cut, "x").at("extreme_ns") == 16'000'000);
  CHECK(pal::test::pal({"simulate", "s.pal", "--until", "20ms"}, files).out.find("  open      x") !=
        std::string::npos);

  // A busy period counts whatever comes.
  CHECK(requirement(cut, "b").at("broken_runs") == 0);
  const OrderedJson later = simulated(ends_before_the_answer, "25ms", ExitStatus::not_met);
  CHECK(requirement(later, "b").at("broken_runs") == 5);

  const OrderedJson whole = simulated(ends_before_the_answer, "1s", ExitStatus::not_met);
  CHECK(requirement(whole, "x").at("open_runs") == 0);
  CHECK(requirement(whole, "x").at("extreme_ns").is_null());
}

TEST_CASE("a value counts that grows where nothing happens any more") {
  const OrderedJson made = simulated(stands_still, "30ms", ExitStatus::not_met);
  CHECK(requirement(made, "x").at("broken_runs") == 5);
  CHECK(requirement(made, "x").at("open_runs") == 0);
  CHECK(requirement(made, "x").at("extreme_ns") == 20'000'000);
}

TEST_CASE("a busy period with very many pauses of no length takes little memory") {
  const OrderedJson made = simulated(never_idle, "20s", ExitStatus::not_met);
  CHECK(requirement(made, "b").at("broken_runs") == 5);
}

TEST_CASE("runs end in the time that is given") {
  const auto begin = std::chrono::steady_clock::now();
  const pal::MemoryFileSystem files = in_memory(never_idle);
  const Answer answer = pal::test::pal(
      {"simulate", "s.pal", "--until", "1min", "--runs", "1000000", "--timeout", "500ms", "--format", "json"},
      files);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
  CHECK(answer.status == ExitStatus::not_met);
  const OrderedJson made = OrderedJson::parse(answer.out).at("simulations").at(0);
  CHECK(made.at("asked") == 1'000'000);
  CHECK(made.at("runs") < 1'000'000);
  CHECK(pal::test::pal({"simulate", "s.pal", "--runs", "1000000", "--timeout", "100ms"}, files)
            .out.find("of 1000000 runs, then --timeout or Ctrl-C ended it") != std::string::npos);

  // A run that is written is whole.
  const std::string trace = temporary("simulate_timeout");
  pal::test::pal({"simulate", touch, "-e", cell, "--runs", "1000000", "--timeout", "3s", "-r", "answer-alter",
                  "--trace", trace});
  CHECK(std::filesystem::file_size(trace) > 1'000);
  std::filesystem::remove(trace);
}

TEST_CASE("a run that is not checked to its end counts for nothing") {
  const auto skill = sound_skill(never_idle);
  pal::analyzer::SimulationOptions how;
  how.until = 2'000'000'000;
  const auto run = pal::program::runs_by_chance(*skill->problem, how, 1).make(0);
  REQUIRE(run);
  REQUIRE(run->trace.events.size() > 2'000);
  int before = 0;
  for (bool whole = false; !whole; ++before) {
    pal::program::Survey survey(*skill->problem);
    int asked = 0;
    whole = survey.add(*run, 0, [&] { return asked++ == before; });
    for (const pal::program::Seen& seen : survey.seen()) CHECK((seen.breaking + seen.values > 0) == whole);
  }
  CHECK(before > 4);
}

TEST_CASE("a thread at work when a run ends has its processor until then") {
  const pal::MemoryFileSystem files = in_memory(text_of("ends_at_work"));
  const auto load = [&](const std::string& until) {
    const Answer answer =
        pal::test::pal({"simulate", "s.pal", "--until", until, "--runs", "3", "--format", "json"}, files);
    INFO(answer.err);
    return requirement(OrderedJson::parse(answer.out).at("simulations").at(0), "r").at("extreme_ns");
  };
  CHECK(load("1ns") == 1'000'000'000);
  CHECK(load("19ms") == 1'000'000'000);
  CHECK(load("80ms") == 250'000'000);
  CHECK(load("110ms") == 272'727'272);
}

TEST_CASE("what a simulated load means beside a proved one is said, and only where there is a load") {
  const pal::MemoryFileSystem files = in_memory(text_of("ends_at_work"));
  const Answer with = pal::test::pal({"simulate", "s.pal", "--until", "80ms", "--runs", "3"}, files);
  CHECK(with.out.find("A load here is that of one whole run") != std::string::npos);
  CHECK(with.out.find("that of the long run") != std::string::npos);
  const Answer without =
      pal::test::pal({"simulate", "s.pal", "--runs", "3"}, in_memory(text_of("two_drivers")));
  CHECK(without.out.find("A load here") == std::string::npos);
}

TEST_CASE("with all times at one end phases are drawn") {
  const auto skill = sound_skill(text_of("ends_at_work"));
  using Times = pal::analyzer::SimulationOptions::Times;
  for (const Times times : {Times::worst, Times::best}) {
    pal::analyzer::SimulationOptions how;
    how.times = times;
    how.until = 30'000'000;
    const pal::program::Runs runs = pal::program::runs_by_chance(*skill->problem, how, 20);
    std::set<std::int64_t> ticks, rings;
    for (std::size_t number = 0; number < 20; ++number) {
      std::set<int> seen;
      const auto run = runs.make(number);
      for (const pal::trace::Event& event : run->trace.events) {
        if (event.kind != pal::trace::Kind::put || !seen.insert(event.subject).second) continue;
        const auto& message = run->trace.channels[static_cast<std::size_t>(event.subject)].message;
        (message == "tick" ? ticks : rings).insert(event.time_ns);
      }
    }
    CHECK(ticks == std::set<std::int64_t>{0});
    CHECK(rings.size() > 10);
    CHECK(*rings.rbegin() <= 10'000'000);
  }
}
