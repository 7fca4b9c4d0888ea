// pal sequence and pal resources.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/unit/program/program.hpp"

using namespace pal;
using program::ExitStatus;

namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string drawn(const std::string& file, const std::string& name) {
  const auto folder = std::filesystem::temp_directory_path() / test::own_name("pal_sequence_" + name);
  std::filesystem::create_directories(folder);
  const auto answer = test::pal({"sequence", file, "-o", folder.string()});
  INFO(answer.err);
  REQUIRE(answer.status == ExitStatus::all_hold);
  const auto text = read(folder / (name + ".1.sequence.svg"));
  std::filesystem::remove_all(folder);
  return text;
}

}  // namespace

TEST_CASE("a deadlock is drawn with each thread that waits, its message and its place") {
  const auto file = std::string(PAL_SOURCE_DIR) + "/tests/golden/check/fail_deadlock.pal";
  const auto svg = drawn(file, "s");
  CHECK(svg.find("<title>s: no module goes on</title>") != std::string::npos);
  CHECK(svg.find("waits for 'force' from LS1 for ever") != std::string::npos);
  CHECK(svg.find(">fail_deadlock.pal:25<") != std::string::npos);
  CHECK(svg == drawn(file, "s"));
}

TEST_CASE("a command that is lost is drawn as never taken") {
  const auto svg = drawn(std::string(PAL_SOURCE_DIR) + "/tests/golden/check/undelivered.pal", "s");
  CHECK(svg.find("SM1 sends motion to MC1, which never takes it") != std::string::npos);
  CHECK(svg.find("completes the skill") != std::string::npos);
}

TEST_CASE("resources names what the environment lacks, by group") {
  const auto whole = test::pal(
      {"resources", test::skill("touch/touch.pal"), "-e", test::skill("workcell.pal"), "--format", "json"});
  REQUIRE(whole.status == ExitStatus::all_hold);
  const auto document = nlohmann::json::parse(whole.out);
  CHECK(document.at(0).at("needs").size() == 14);  // the skill brings the times of its own activities
  CHECK(document.at(0).at("environments").at(0).at("missing").empty());

  MemoryFileSystem files;
  for (const char* name : {"touch/touch.pal", "touch/touch_modules.pal", "modules/force_torque.pal",
                           "modules/z_force.pal", "modules/alter.pal", "modules/retreat.pal"})
    files.add(name, read(test::skill(name)));
  files.add(
      "bare.pal",
      "ENVIRONMENT bare\n  PROCESSOR P0\n  DEVICE alter EVENT tick EVERY 28 ms\n  PLACE SM1 ON P0 PRIORITY "
      "1\n"
      "  PLACE MC1 ON P0 PRIORITY 2\n  TIME obey OF MC1 : 1 ms\n  TIME advance : 1 ms\nEND ENVIRONMENT\n");
  const auto partial =
      test::pal({"resources", "touch/touch.pal", "-e", "bare.pal", "--format", "json"}, files);
  CHECK(partial.status == ExitStatus::wrong_specification);
  const auto compared = nlohmann::json::parse(partial.out);
  std::vector<std::string> missing;
  for (const auto& one : compared.at(0).at("environments").at(0).at("missing"))
    missing.push_back(std::string(one.at("group")) + ": " + std::string(one.at("name")));
  CHECK(missing == std::vector<std::string>{"sensor drivers: SD1", "sensor drivers: force-torque",
                                            "logical sensors: LS1", "activities: extract-z",
                                            "activities: hold", "activities: retreat"});
  CHECK(compared.size() == 1);
  const auto check = test::pal({"check", "touch/touch.pal", "-e", "bare.pal"}, files);
  CHECK(check.err.find("error[PAL0721]: environment bare does not place SD1") != std::string::npos);
  CHECK(check.err.find("PAL0740") == std::string::npos);  // each lack is told once
}

TEST_CASE("several skills are compared each for itself and as one operation") {
  MemoryFileSystem files;
  const auto skill = [](const std::string& name, const std::string& machine) {
    return "SKILL " + name + "\n  MACHINE CONTROLLER " + machine + "\n  SKILL METHOD " + name +
           "-method\n  COMPLETION 0 NORMAL\n  COMPLETION 1 ERROR\nEND SKILL\nMachine Controller: " + machine +
           "\nSkill Module: " + name + "-method\n  ACTIVITY " + name +
           "-work\nBEGIN\n  WTM( Coordinator )\n  " + name + "-work\n  TXM( light to " + machine +
           " )\n  TXM( Completion Protocol 0 )\nEND\n";
  };
  files.add("two.pal", "MESSAGE light : SIGNAL\n" + skill("one", "MC1") + skill("two", "MC2") +
                           "ENVIRONMENT cell\n  MACHINE CONTROLLER MC1, MC2\n  GENERIC SKILL one\n"
                           "  PROCESSOR P0\n  PLACE one-method ON P0 PRIORITY 1\n  TIME one-work : 1 ms\n"
                           "  TIME two-work : 1 ms\nEND ENVIRONMENT\n");
  const auto answer = test::pal({"resources", "two.pal", "--format", "json"}, files);
  INFO(answer.err);
  CHECK(answer.status == ExitStatus::wrong_specification);
  const auto document = nlohmann::json::parse(answer.out);
  REQUIRE(document.size() == 3);
  const auto missing = [&](std::size_t i) {
    std::vector<std::string> names;
    for (const auto& one : document.at(i).at("environments").at(0).at("missing"))
      names.push_back(std::string(one.at("group")) + ": " + std::string(one.at("name")));
    return names;
  };
  CHECK(document.at(0).at("skill") == "one");
  CHECK(missing(0).empty());
  const std::vector<std::string> lacks = {"generic skills: two", "skill modules: two-method"};
  CHECK(document.at(1).at("skill") == "two");
  CHECK(missing(1) == lacks);
  CHECK(document.at(2).at("operation") == nlohmann::json({"one", "two"}));
  CHECK(missing(2) == lacks);
  // Nothing that both need is told twice, and nothing that one of them needs is left out.
  CHECK(document.at(2).at("needs").size() ==
        document.at(0).at("needs").size() + document.at(1).at("needs").size());
  const auto text = test::pal({"resources", "two.pal"}, files).out;
  CHECK(text.find("an operation of one, two needs\n") != std::string::npos);
  const auto check = test::pal({"check", "two.pal"}, files);
  CHECK(check.err.find("PAL0740") != std::string::npos);
  CHECK(check.err.find("generic skills: 'two'") != std::string::npos);
}
