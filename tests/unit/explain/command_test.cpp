// pal explain.
#include <catch2/catch.hpp>

#include "tests/unit/program/program.hpp"

using pal::program::ExitStatus;

TEST_CASE("pal explain prints the page of a code, written in any way") {
  const auto answer = pal::test::pal({"explain", "PAL0401"});
  CHECK(answer.status == ExitStatus::all_hold);
  CHECK(answer.out.find("PAL0401") != std::string::npos);
  CHECK(answer.out.find("### Cure") != std::string::npos);
  CHECK(pal::test::pal({"explain", "pal0401"}).out == answer.out);
  CHECK(pal::test::pal({"explain", "401"}).out == answer.out);
  CHECK(pal::test::pal({"explain", "401", "402"}).out.find("PAL0402") != std::string::npos);
}

TEST_CASE("pal explain suggests codes near to an unknown one") {
  const auto answer = pal::test::pal({"explain", "PAL0400"});
  CHECK(answer.status == ExitStatus::usage);
  CHECK(answer.out.empty());
  CHECK(answer.err.find("'PAL0400'") != std::string::npos);
  CHECK(answer.err.find("PAL0401") != std::string::npos);
  CHECK(pal::test::pal({"explain", "deadlock"}).err.find("PAL0521  deadlock") != std::string::npos);
  CHECK(pal::test::pal({"explain", "xyzzy"}).err.find("--list") != std::string::npos);
  CHECK(pal::test::pal({"explain"}).status == ExitStatus::usage);
}

TEST_CASE("pal explain --list shows every code with severity and title") {
  const auto answer = pal::test::pal({"explain", "--list"});
  CHECK(answer.status == ExitStatus::all_hold);
  CHECK(answer.out.find("PAL0101  error    syntax error\n") != std::string::npos);
  CHECK(answer.out.find("PAL0404  warning  condition that may be read before it is set\n") !=
        std::string::npos);
}
