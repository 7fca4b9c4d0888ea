// The examples run in the workcell, from their START to their ends.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim/program/command_line.hpp"

using namespace pal::workcell;

namespace {

struct Answer {
  ExitStatus status;
  std::string out, error;
  std::vector<nlohmann::json> steps;
};

Answer run(const std::string& example, std::vector<std::string> options, const std::string& lines = "") {
  const auto log =
      std::filesystem::temp_directory_path() / ("operation-" + std::to_string(::getpid()) + ".jsonl");
  options.insert(options.begin(),
                 {"operation", "run", PAL_SOURCE_DIR "/examples/operations/" + example + ".op.json", "--log",
                  log.string()});
  std::istringstream in(lines);
  std::ostringstream out, error;
  Answer answer{main_program(options, linked_skills(), out, error, false, &in), out.str(), error.str(), {}};
  std::ifstream file(log);
  for (std::string line; std::getline(file, line);) answer.steps.push_back(nlohmann::json::parse(line));
  std::filesystem::remove(log);
  return answer;
}

std::vector<std::string> icons(const Answer& answer) {
  std::vector<std::string> result;
  for (const auto& step : answer.steps) result.push_back(step.at("icon"));
  return result;
}

}  // namespace

TEST_CASE("rub in square finds the plate, rubs four sides and leaves") {
  const Answer answer = run("rub_in_square", {"--scene", "touch"});
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  CHECK(icons(answer) == std::vector<std::string>{"find", "rub-in-square/side-1", "rub-in-square/side-2",
                                                  "rub-in-square/side-3", "rub-in-square/side-4", "lift"});
  for (const auto& step : answer.steps) CHECK(step.at("code") == 0);
  CHECK(answer.out.find("exit 'done' with code 0") != std::string::npos);
}

TEST_CASE("pick and place goes round until the steps are up") {
  const Answer answer = run("pick_and_place", {"--scene", "parts", "--steps", "7"});
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  CHECK(icons(answer) ==
        std::vector<std::string>{"go-home", "pick", "place", "pick-again", "place-back", "go-home", "pick"});
  for (const auto& step : answer.steps) CHECK(step.at("code") == 0);
}

TEST_CASE("a pallet is filled, and the operation says so") {
  const Answer answer = run("fill_a_pallet", {"--scene", "pallet"});
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  CHECK(answer.out.find("exit 'pallet-full' with code 0") != std::string::npos);
  CHECK(answer.steps.back().at("code") == 1);
}

TEST_CASE("an operation is stepped and changed by hand") {
  const Answer answer = run("rub_in_square", {"--scene", "touch", "--step"},
                            "break rub-in-square/side-1\nrun\nset rub-in-square/side-1 distance 1\nset "
                            "rub-in-square/side-1 distance 900\nstep\nquit\n");
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  REQUIRE(answer.steps.size() == 2);
  CHECK(answer.steps[1].at("parameters").at("distance") == 1);
  CHECK(answer.out.find("write a number from 0.1 to 50 cm") != std::string::npos);
}

TEST_CASE("what cannot be run is refused before anything moves") {
  CHECK(run("nothing", {}).status == ExitStatus::usage);
  CHECK(run("rub_in_square", {"--from", "nowhere"}).status == ExitStatus::wrong_specification);
  CHECK(run("rub_in_square", {"--break", "find=x"}).status == ExitStatus::usage);
}
