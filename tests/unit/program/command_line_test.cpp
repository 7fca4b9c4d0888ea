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
  CHECK(pal::test::pal({"help", "check"}).out == pal::test::pal({"check", "--help"}).out);
  CHECK(pal::test::pal({"help", "operation", "check"}).out ==
        pal::test::pal({"operation", "check", "--help"}).out);
  CHECK(pal::test::pal({"help"}).out == pal::test::pal({"--help"}).out);
}

TEST_CASE("an option that there is not says which is meant") {
  const auto answer = pal::test::pal({"check", touch, "--enviroment", cell});
  CHECK(answer.status == ExitStatus::usage);
  CHECK(answer.err.find("did you mean '--environment'?") != std::string::npos);
  CHECK(pal::test::pal({"check", touch, "--formt=json"}).err.find("did you mean '--format'?") !=
        std::string::npos);
  CHECK(pal::test::pal({"check", touch, "--zzzzzzz"}).err.find("did you mean") == std::string::npos);
}

TEST_CASE("shells complete commands, options and words") {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const auto answer = pal::test::pal({"completion", shell});
    CAPTURE(shell);
    CHECK(answer.status == ExitStatus::all_hold);
    for (const char* word : {"whatif", "storyboard", "require-verdicts", "compositional"})
      CHECK(answer.out.find(word) != std::string::npos);
  }
  CHECK(pal::test::pal({"completion", "csh"}).status == ExitStatus::usage);
}

TEST_CASE("a chart is not written under the name of another form") {
  expect_refused({"atc", touch, "-e", cell, "-o", "w.png"}, "rsvg-convert -o w.png w.svg");
  expect_refused({"atc", touch, "-e", cell, "-o", "w.pdf"}, "rsvg-convert -f pdf -o w.pdf w.svg");
  expect_refused({"atc", touch, "-e", cell, "-o", "w.svg", "--format", "html"}, "cannot write w.svg");
  expect_refused({"pan", touch, "-o", "p.svg"}, "-o takes a folder");
  expect_refused({"pan", touch, "--module", "SM1", "-o", "p.png"}, "the drawing is SVG");
}

TEST_CASE("a folder stands for the PAL files in it") {
  pal::MemoryFileSystem files;
  files.add("f/a.pal", "CONDITION $\n");
  files.add("f/g/b.pal", "CONDITION $\n");
  const auto answer = pal::test::pal({"check", "f"}, files);
  CHECK(answer.err.find("f/a.pal:1") != std::string::npos);
  CHECK(answer.err.find("f/g/b.pal:1") != std::string::npos);
}
