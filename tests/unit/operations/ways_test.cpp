#include "operations/ways.hpp"

#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;
using namespace std::chrono_literals;

namespace {

Skills go_and_back() {
  Skills skills;
  pan::Completion done, none;
  none.code = 1;
  none.kind = pan::Completion::Kind::contingency;
  skills["go"].completions = {done, none};
  skills["back"].completions = {done};
  return skills;
}

}  // namespace

TEST_CASE("times add up along each way") {
  const auto program = test::program_of(test::operation(
      R"({"id": "a", "kind": "skill", "skill": "go", "next": "d", "error": "end"},)"
      R"({"id": "d", "kind": "delay", "seconds": 2, "next": "b"},)"
      R"({"id": "b", "kind": "skill", "skill": "back", "next": "end"}, {"id": "end", "kind": "exit"})"));
  const Ways ways = ways_through(program, go_and_back(), {{{{"go", 0}, 3s}, {{"back", 0}, 5s}}});
  REQUIRE(ways.ways.size() == 2);
  CHECK(ways.ways[0].icons == std::vector<std::string>{"a (0)", "d", "b (0)"});
  CHECK(ways.ways[0].longest == Duration(10s));
  CHECK(ways.ways[0].shortest == Duration(2s));
  CHECK(ways.ways[1].end == "exit end with code 1");
  CHECK_FALSE(ways.ways[1].longest);
  CHECK(ways.ways[1].unbounded == std::vector<std::string>{"go"});
}

TEST_CASE("a loop is told once, and too many ways are cut off") {
  const auto program = test::program_of(test::operation(test::looping));
  const Ways ways = ways_through(program, go_and_back(), {});
  REQUIRE(ways.ways.size() == 2);
  CHECK(ways.ways[0].end == "exit end with code 0");
  CHECK(ways.ways[1].end == "back to a");
  CHECK(ways.complete);
  CHECK_FALSE(ways_through(program, go_and_back(), {}, 1).complete);
}
