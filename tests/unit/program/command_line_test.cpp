// What every command does with its command line.
#include <catch2/catch.hpp>

#include "tests/unit/program/program.hpp"

using namespace pal::test;
using pal::program::ExitStatus;

TEST_CASE("a command line that cannot be understood ends with 2") {
  CHECK(pal::test::pal({}).status == ExitStatus::usage);
  CHECK(pal::test::pal({"check"}).status == ExitStatus::usage);
  CHECK(pal::test::pal({"check", touch, "--format", "xml"}).status == ExitStatus::usage);
  CHECK(pal::test::pal({"check", touch, "--skill", "tuch"}).status == ExitStatus::usage);
  CHECK(pal::test::pal({"check", touch, "--skill", "tuch"}).err.find("'touch'") != std::string::npos);
}

TEST_CASE("a missing file ends with 2 if the command line names it, with 1 if USES does") {
  pal::MemoryFileSystem files;
  files.add("uses.pal", "USES \"missing.pal\"\n");
  CHECK(pal::test::pal({"check", "missing.pal"}, files).status == ExitStatus::usage);
  CHECK(pal::test::pal({"check", "uses.pal"}, files).status == ExitStatus::wrong_specification);
}

TEST_CASE("an unknown command says which there are") {
  const auto answer = pal::test::pal({"chekc", touch});
  CHECK(answer.status == ExitStatus::usage);
  CHECK(answer.err.find("did you mean 'check'?") != std::string::npos);
}

TEST_CASE("help and version end with 0") {
  for (const std::string command : {"check", "pan", "atc", "generate"}) {
    const auto answer = pal::test::pal({command, "--help"});
    CHECK(answer.status == ExitStatus::all_hold);
    CHECK(answer.out.find("Exit status") != std::string::npos);
  }
  CHECK(pal::test::pal({"--version"}).out.find("pal 0.") == 0);
}
