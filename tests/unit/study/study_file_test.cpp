#include "study/study_file.hpp"

#include <catch2/catch.hpp>

#include "study/values.hpp"

using namespace pal::study;

namespace {

const std::string head = "files = [\"s.pal\"]\n";

Study good(const std::string& text) {
  const auto study = read_study(head + text);
  if (const auto* refusal = std::get_if<Refusal>(&study)) FAIL(refusal->what);
  return std::get<Study>(study);
}

Refusal bad(const std::string& text) {
  const auto study = read_study(text);
  REQUIRE(std::holds_alternative<Refusal>(study));
  return std::get<Refusal>(study);
}

std::vector<std::string> values(const Range& range) {
  const auto made = values_of(range);
  if (const auto* wrong = std::get_if<std::string>(&made)) FAIL(*wrong);
  return std::get<std::vector<std::string>>(made);
}

std::string wrong(const Range& range) {
  const auto made = values_of(range);
  REQUIRE(std::holds_alternative<std::string>(made));
  return std::get<std::string>(made);
}

}  // namespace

TEST_CASE("a range goes from its first value to its last by steps, or in so many values") {
  CHECK(values({"1 ms", "2 ms", "500 us", {}, {}, 0}) == std::vector<std::string>{"1 ms", "1.5 ms", "2 ms"});
  CHECK(values({"1", "7", "3", {}, {}, 0}) == std::vector<std::string>{"1", "4", "7"});
  CHECK(values({"1 ms", "2 ms", "400 us", {}, {}, 0}) ==
        std::vector<std::string>{"1 ms", "1.4 ms", "1.8 ms"});
  CHECK(values({"0 ms", "1 ms", {}, 3, {}, 0}) == std::vector<std::string>{"0 ms", "500 us", "1 ms"});
  CHECK(values({"5 ms", "9 ms", {}, 1, {}, 0}) == std::vector<std::string>{"5 ms"});
  CHECK(values({"0", "10", {}, 4, {}, 0}) == std::vector<std::string>{"0", "3", "6", "10"});
}

TEST_CASE("random values are picked once each, in order, and the seed says which") {
  const Range range{"1 ms", "1 s", "1 ms", {}, 20, 7};
  const auto picked = values(range);
  REQUIRE(picked.size() == 20);
  CHECK(picked == values(range));
  CHECK(picked.front() == "150 ms");  // on every machine
  Range other = range;
  other.seed = 8;
  CHECK(values(other) != picked);
  CHECK(values({"1", "3", "1", {}, 3, 1}) == std::vector<std::string>{"1", "2", "3"});
}

TEST_CASE("a range without a value, or with too many, is refused before it is made") {
  CHECK(wrong({"2 ms", "1 ms", "1 ms", {}, {}, 0}) == "the range is empty: it goes from 2 ms to 1 ms");
  CHECK(wrong({"1 ms", "2 ms", {}, 0, {}, 0}) == "the range is empty: 'count' is 0");
  CHECK(wrong({"0 ms", "1 s", "1 ns", {}, {}, 0}) ==
        "the range has 1000000001 values; a figure has at most 100000");
  CHECK(wrong({"1 ms", "2 ms", "0 ms", {}, {}, 0}) == "'0 ms' is no step from 1 ms to 2 ms");
  CHECK(wrong({"1 ms", "2", "1 ms", {}, {}, 0}) == "'from' and 'to' are not both times");
  CHECK(wrong({"soon", "2 ms", "1 ms", {}, {}, 0}) ==
        "'soon' is neither a time, as \"20 ms\" is, nor a whole number");
  CHECK(wrong({"1", "3", "1", {}, 4, 1}) == "'random' asks for 4 different values, and the range has 3");
  CHECK(wrong({"1", "3", {}, {}, {}, 1}) == "a range needs one of 'step' and 'count'");
}

TEST_CASE("a figure changes what it is called, or what its 'set' says") {
  const Study study = good(R"(
[[figure]]
name = "MC1.period"
values = ["5 ms", "10 ms"]
[[figure]]
name = "priority"
set = ["SM1.priority = {}", "LS1.priority = {}"]
from = 1
to = 2
step = 1
[[figure]]
name = "places"
[[figure.choice]]
name = "as it is"
set = []
[[figure.choice]]
name = "two processors"
set = ["PROCESSOR P1", "SM1.processor = P1"]
)");
  REQUIRE(study.figures.size() == 3);
  CHECK(study.figures[0].choices[1].changes == std::vector<std::string>{"MC1.period = 10 ms"});
  CHECK(study.figures[1].choices[1].changes ==
        std::vector<std::string>{"SM1.priority = 2", "LS1.priority = 2"});
  CHECK(study.figures[2].choices[0].changes.empty());
  CHECK(study.figures[2].choices[1].label == "two processors");
  REQUIRE(study.plots.size() == 1);  // two figures are a map
  CHECK(study.plots[0].over == std::vector<std::size_t>{0, 1});
}

TEST_CASE("what a study does not know is refused with its line") {
  const Refusal key = bad(head + "enviroments = [\"c.pal\"]\n");
  CHECK(key.line == 2);
  CHECK(key.what == "a study has no 'enviroments'");
  CHECK(key.hint == "did you mean 'environments'?");
  CHECK(bad("title = \"x\"").what == "the study names no files");
  CHECK(bad("files = [").what.starts_with("this is no TOML"));
  CHECK(bad(head + "[[figure]]\nvalues = [1]\n").what == "a figure has no name");
  CHECK(bad(head + "[[figure]]\nname = \"a\"\nvalues = []\n").what == "the list 'values' is empty");
  CHECK(bad(head + "[[figure]]\nname = \"a\"\nvalues = [1, 1]\n").what == "figure 'a' has '1' twice");
  CHECK(bad(head + "[[figure]]\nname = \"a\"\nvalues = [1.5]\n").what ==
        "'values' has something that is neither a text nor a whole number");
  CHECK(bad(head + "[[figure]]\nname = \"a\"\nvalues = [1]\nset = [\"b = 2\"]\n").what ==
        "'set' of figure 'a' does not say where its value goes");
  CHECK(bad(head + "[[figure]]\nname = \"a\"\nfrom = 1\nto = 9\nstep = 1\nrandom = 2\n").what ==
        "figure 'a' has random values without a seed");
  CHECK(bad(head + "[[plot]]\nover = [\"a\"]\n").what ==
        "a plot is over 'a', which is no figure of this study");
  CHECK(bad(head + "[limits]\ntimeout = \"soon\"\n").what == "'soon' is no length of time");
  CHECK(bad(head + "[limits]\nanalysis = \"half-open\"\n").what == "there is no analysis 'half-open'");
}
