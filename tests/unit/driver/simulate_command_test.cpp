// pal simulate: runs by chance and by script.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/unit/driver/program.hpp"

using namespace pal::test;
using pal::driver::ExitStatus;
using Json = nlohmann::ordered_json;

namespace {

const std::string cell = skill("workcell.pal");
const std::string touch = skill("touch/touch.pal");
const std::string read_first = skill("touch/touch_read_first.pal");

Json simulated(std::vector<std::string> arguments, ExitStatus status) {
  arguments.insert(arguments.begin(), "simulate");
  for (const char* more : {"-e", cell.c_str(), "--format", "json"}) arguments.emplace_back(more);
  const Answer answer = pal::test::pal(arguments);
  INFO(answer.err);
  CHECK(answer.status == status);
  return Json::parse(answer.out).at("simulations").at(0);
}

Json requirement(const Json& simulation, const std::string& name) {
  for (const Json& row : simulation.at("requirements")) {
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
  const Json kept = simulated({touch}, ExitStatus::all_hold);
  CHECK(kept.at("runs") == 100);
  CHECK(kept.at("completed") == 100);
  CHECK(requirement(kept, "fresh-force").at("extreme_ns") <= 7'300'000);
  CHECK(requirement(kept, "fresh-force").at("values") > 30);
  CHECK(requirement(kept, "headroom").at("extreme_ns") > 0);

  const Json broken = simulated({read_first}, ExitStatus::not_met);
  const Json fresh = requirement(broken, "fresh-force");
  CHECK(fresh.at("broken_runs") > 10);
  CHECK(fresh.at("extreme_ns") > 10'000'000);
  CHECK(fresh.at("extreme_ns") <= 35'000'000);
  CHECK(requirement(broken, "answer-alter").at("broken_runs") == 0);
}

TEST_CASE("the same seed is the same run, and the run that is named shows the value") {
  const Json all = simulated({read_first}, ExitStatus::not_met);
  const Json fresh = requirement(all, "fresh-force");
  const std::string seed = fresh.at("run").get<std::string>().substr(std::string("seed ").size());
  const Json one = simulated({read_first, "--seed", seed, "--runs", "1"}, ExitStatus::not_met);
  CHECK(one.at("runs") == 1);
  CHECK(requirement(one, "fresh-force").at("extreme_ns") == fresh.at("extreme_ns"));
}

TEST_CASE("every witness can be made again from its script alone, and shows the bound") {
  const std::string file = temporary("simulate_script");
  CHECK(pal::test::pal({"check", read_first, "-e", cell, "--witness", file}).status == ExitStatus::not_met);
  const Json made = simulated({read_first, "--script", file}, ExitStatus::not_met);
  CHECK(made.at("runs") == 4);
  CHECK(made.at("refused").empty());
  CHECK(requirement(made, "fresh-force").at("extreme_ns") == 35'000'000);
  CHECK(requirement(made, "answer-alter").at("extreme_ns") == 4'400'000);

  // The events are not looked at: without them it is the same run.
  Json witnesses = [&] {
    std::ifstream in(file);
    return Json::parse(in);
  }();
  Json bare = witnesses;
  for (Json& witness : bare.at("witnesses")) witness.at("run").at("events") = Json::array();
  std::ofstream(file) << bare;
  CHECK(simulated({read_first, "--script", file}, ExitStatus::not_met) == made);

  // A script that fires earlier than anything can.
  for (Json& firing : witnesses.at("witnesses").at(1).at("script")) firing.at("at_ns") = 0;
  std::ofstream(file) << witnesses;
  const Json refused = simulated({read_first, "--script", file}, ExitStatus::not_met).at("refused");
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

TEST_CASE("what cannot be simulated is said") {
  const auto said = [](const std::vector<std::string>& arguments, const std::string& text) {
    const Answer answer = pal::test::pal(arguments);
    INFO(answer.err);
    CHECK(answer.status == ExitStatus::usage);
    CHECK(answer.err.find(text) != std::string::npos);
  };
  said({"simulate", touch}, "give an environment with --environment FILE");
  said({"simulate", touch, "-e", cell, "--runs", "0"}, "--runs");
  said({"simulate", touch, "-e", cell, "--until", "soon"}, "no length of time");
  said({"simulate", touch, "-e", cell, "--script", "/nowhere.json"}, "cannot read '/nowhere.json'");
  said({"simulate", touch, "-e", cell, "--script", touch}, "is no file of witnesses");
  said({"simulate", touch, "-e", cell, "-r", "fresh"},
       "no requirement is called 'fresh'; there is 'answer-alter'");
  said({"simulate", touch, "-e", cell, "--until", "0", "-r", "answer-alter", "--trace", "/tmp/x"},
       "no run shows a value of 'answer-alter'");
  said({"simulate", cell}, "there is no skill to simulate");
}
