#include "tests/unit/driver/program.hpp"

#include <catch2/catch.hpp>

using pal::driver::ExitStatus;
using pal::test::Answer;

namespace {

const std::string touch = pal::test::skill("touch/touch.pal");
const std::string read_first = pal::test::skill("touch/touch_read_first.pal");
const std::string cell = pal::test::skill("workcell.pal");
const std::string places = std::string(PAL_SOURCE_DIR) + "/tests/figures/figure_3_6_places.pal";

bool says(const Answer& answer, const std::string& text) {
  return answer.out.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("slack: what fails as things are, what is not known, what was not looked for") {
  const Answer fails = pal::test::pal({"whatif", read_first, "-e", cell});
  CHECK(fails.status == ExitStatus::not_met);
  CHECK(says(fails, "none              'fresh-force' does not hold as things are"));

  // Ended before anything was decided: nothing is said to fail.
  const Answer ended = pal::test::pal({"whatif", touch, "-e", cell, "--timeout", "1ns"});
  CHECK(ended.status == ExitStatus::not_met);
  CHECK(says(ended, "not known"));
  CHECK(says(ended, "is undecided as things are"));
  CHECK_FALSE(says(ended, "does not hold"));
}

TEST_CASE("how few processors do is said of the priorities that were tried") {
  const Answer kept = pal::test::pal({"whatif", places, "--environment-name", "reading", "--place", "0"});
  CHECK(says(kept, "2 processors do; with the priorities as they are fewer do not: each placement"));
  const Answer all =
      pal::test::pal({"whatif", places, "--environment-name", "reading", "--place", "0", "--priorities"});
  CHECK(says(all, "2 processors do; fewer do not: each placement"));
}

TEST_CASE("what an option cannot be is refused with what it can be") {
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& text) {
    const Answer answer = pal::test::pal(arguments);
    INFO(answer.err);
    CHECK(answer.status == ExitStatus::usage);
    CHECK(answer.err.find(text) != std::string::npos);
  };
  refused({"check", touch, "--format", "xml"}, "'xml' is none of json, sarif, text");
  refused({"check", touch, "--format", "1"}, "'1' is none of json, sarif, text");
  refused({"check", touch, "--analysis", "long"}, "'long' is none of auto, compositional, exact");
  refused({"check", touch, "--max-states", "-1"}, "'-1' is no whole number from 0 on");
  refused({"check", touch, "--threads", "many"}, "'many' is no whole number from 0 on");
  refused({"check", touch, "--max-errors", "-1"}, "'-1' is no whole number from 0 on");
  refused({"simulate", touch, "-e", cell, "--seed", "-1"}, "'-1' is no whole number from 0 on");
  refused({"simulate", touch, "-e", cell, "--times", "odd"},
          "'odd' is none of best, extremes, random, worst");
}
