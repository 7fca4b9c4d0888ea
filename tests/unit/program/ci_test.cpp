// What CI services read: exit statuses, JUnit reports, quiet runs.
#include <filesystem>

#include "tests/unit/program/program.hpp"

namespace pal::test {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST_CASE("a JUnit report has a case for each file and each requirement") {
  const Answer answer = pal({"check", read_first, "-e", cell, "--format", "junit"});
  CHECK(answer.status == program::ExitStatus::not_met);
  CHECK(count(answer.out, "<testcase ") == 7 + 4);
  CHECK(count(answer.out, "<failure ") == 1);
  CHECK(count(answer.out, "name=\"fresh-force\" time=") == 1);
  CHECK(count(answer.out,
              "<failure type=\"PAL0890\" message=\"PAL0890: 'fresh-force' fails: age of pc-force") == 1);
}

TEST_CASE("errors of a file fail its own case in a JUnit report") {
  const Answer answer =
      pal({"check", "s.pal", "--format", "junit"}, in_memory("CONDITION a\nDEVICE $ & d\n"));
  CHECK(answer.status == program::ExitStatus::wrong_specification);
  CHECK(count(answer.out, "<failure type=\"PAL0102\" message=\"PAL0102: unexpected character") == 1);
  CHECK(answer.out.find("DEVICE $ &amp; d") != std::string::npos);
}

TEST_CASE("a quiet check says nothing of what holds, and all of what does not") {
  const Answer holds = pal({"check", touch, "-e", cell, "--quiet"});
  CHECK(holds.status == program::ExitStatus::all_hold);
  CHECK(holds.out.empty());
  CHECK(holds.err.empty());
  const Answer fails = pal({"check", read_first, "-e", cell, "--quiet"});
  CHECK(fails.err.find("PAL0890") != std::string::npos);
}

TEST_CASE("no code is generated of a skill that is late, unless told otherwise") {
  const auto folder = std::filesystem::temp_directory_path() / own_name("pal-late");
  std::vector<std::string> arguments{"generate", read_first, "-e", cell, "-o", folder.string()};
  const Answer refused = pal(arguments);
  CHECK(refused.status == program::ExitStatus::not_met);
  CHECK(refused.err.find("--allow-failing") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder));
  arguments.push_back("--allow-failing");
  CHECK(pal(arguments).status == program::ExitStatus::all_hold);
  CHECK(std::filesystem::exists(folder / "touch_read_first_skill.cpp"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace pal::test
