// A value that grows with each turn of a loop, in every form.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tests/unit/program/program.hpp"

namespace pal::test {
namespace {

MemoryFileSystem tapping() {
  return in_memory(project_file("tests/golden/check/fail_grows_in_loop.pal"));
}

/// The beginning of a report, up to where it says how the run goes.
std::string beginning_of(const std::string& text) {
  return text.substr(0, text.find(" in bench"));
}

}  // namespace

TEST_CASE("what grows in a loop has no figure that follows the limits of the search") {
  const Answer few = pal({"check", "s.pal", "--max-states", "2000"}, tapping());
  const Answer many = pal({"check", "s.pal", "--max-states", "50000"}, tapping());
  CHECK(few.status == program::ExitStatus::not_met);
  CHECK(few.err == many.err);
  CHECK(beginning_of(few.err).find("grows with each turn of the loop at s.pal:") != std::string::npos);
  CHECK(few.out.find("unbounded") != std::string::npos);
}

TEST_CASE("the hint of what grows in a loop offers a phase that mends it") {
  const Answer late = pal({"check", "s.pal"}, tapping());
  CHECK(late.err.find("DURING REPEAT OF SPC( touched ) IN SM1") != std::string::npos);
  std::string text = project_file("tests/golden/check/fail_grows_in_loop.pal");
  const std::string limit = "AT MOST 40 ms";
  text.replace(text.find(limit), limit.size(), limit + " DURING REPEAT OF SPC( touched ) IN SM1");
  const Answer mended = pal({"check", "s.pal"}, in_memory(text));
  CHECK(mended.out.find("holds      fresh") != std::string::npos);
}

TEST_CASE("JSON names the loop in which a value grows") {
  const Answer answer = pal({"check", "s.pal", "--format", "json"}, tapping());
  const auto row = nlohmann::json::parse(answer.out).at("requirements").front();
  CHECK(row.at("verdict") == "fails");
  CHECK(row.at("bound_ns").is_null());
  CHECK(row.at("grows_in_loop").at("file") == "s.pal");
  CHECK(row.at("grows_in_loop").at("line").get<int>() > 0);
}

TEST_CASE("the chart of what grows in a loop shows its first turns") {
  const std::string folder = own_name("grows");
  const Answer answer =
      pal({"atc", "s.pal", "-r", "fresh", "-o", folder + ".svg", "--timeout", "60"}, tapping());
  INFO(answer.err);
  REQUIRE(answer.status == program::ExitStatus::all_hold);
  std::ifstream file(folder + ".svg");
  const std::string svg((std::istreambuf_iterator<char>(file)), {});
  std::remove((folder + ".svg").c_str());
  CHECK(svg.size() < 200'000);
  CHECK(svg.find("grows with each turn of a loop") != std::string::npos);
}

TEST_CASE("what-if offers the phase as a change of the requirement") {
  std::string text = project_file("tests/golden/check/fail_grows_in_loop.pal");
  const auto other = text.find("  REQUIREMENT done");
  text.erase(other, text.find('\n', other) - other + 1);
  const Answer answer = pal({"whatif", "s.pal", "--timeout", "60"}, in_memory(text));
  INFO(answer.out);
  CHECK(answer.out.find("require fresh only DURING REPEAT OF SPC( touched ) IN SM1") != std::string::npos);
}

}  // namespace pal::test
