// Checks take time that grows with the operation, however it is nested, and can be stopped.
#include <chrono>
#include <sstream>

#include "operations/codes.hpp"
#include "operations/graph.hpp"
#include "operations/storyboard.hpp"
#include "operations/ways.hpp"
#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;

namespace {

constexpr const char* header = R"({"operation-format": 1, "name": "o", "icons": [)";

Skills going() {
  Skills skills;
  pan::Completion done, bad;
  bad.code = 2;
  bad.kind = pan::Completion::Kind::error;
  skills["go"].name = "go";
  skills["go"].completions = {done, bad};
  return skills;
}

/// Skills behind one another, each with its own way to the end for its error.
std::string many_icons(int count) {
  std::string text = std::string(header) + R"({"id": "s", "kind": "start", "next": "i0"})";
  for (int i = 0; i < count; ++i)
    text += R"(, {"id": "i)" + std::to_string(i) + R"(", "kind": "skill", "skill": "go", "next": ")" +
            (i + 1 < count ? "i" + std::to_string(i + 1) : "end") + R"(", "error": "end"})";
  return text + R"(, {"id": "end", "kind": "exit"}]})";
}

/// Skills, all of which lead into one line of as many MERGEs, with a CASE at its end.
std::string many_merges(int count) {
  std::string text = std::string(header) + R"({"id": "s", "kind": "start", "next": "i0"})";
  for (int i = 0; i < count; ++i) {
    const std::string number = std::to_string(i), next = std::to_string(i + 1);
    text += R"(, {"id": "i)" + number + R"(", "kind": "skill", "skill": "go", "next": "m)" + number +
            R"(", "error": ")" + (i + 1 < count ? "i" + next : "m0") + R"("})";
    text += R"(, {"id": "m)" + number + R"(", "kind": "merge", "next": ")" +
            (i + 1 < count ? "m" + next : "c") + R"("})";
  }
  return text +
         R"(, {"id": "c", "kind": "case", "ways": [{"codes": [0], "to": "end"}, {"codes": [7], "to": "end"}],)"
         R"( "default": "end"}, {"id": "end", "kind": "exit"}]})";
}

/// Each operation is the next one, `uses` times behind one another; the last one runs a skill.
std::string nested(int levels, int uses) {
  std::string text = std::string(header);
  const auto body = [&](int level) {
    std::string icons = R"({"id": "s", "kind": "start", "next": "a0"})";
    for (int i = 0; i < uses; ++i) {
      const std::string what = level + 1 < levels
                                   ? R"("operation", "operation": "o)" + std::to_string(level + 1)
                                   : std::string(R"("skill", "skill": "go)");
      icons += R"(, {"id": "a)" + std::to_string(i) + R"(", "kind": )" + what + R"(", "next": ")" +
               (i + 1 < uses ? "a" + std::to_string(i + 1) : "end") + R"(", "error": "bad"})";
    }
    return icons + R"(, {"id": "end", "kind": "exit", "code": 0}, {"id": "bad", "kind": "exit", "code": 2}])";
  };
  text += body(0) + R"(, "operations": [)";
  for (int level = 1; level < levels; ++level)
    text += (level > 1 ? ", " : "") + (R"({"name": "o)" + std::to_string(level)) + R"(", "icons": [)" +
            body(level) + "}";
  return text + "]}";
}

/// All wrong names, each for itself.
std::string all_wrong(int count) {
  std::string text = std::string(header) + R"({"id": "s", "kind": "start", "next": "i0"})";
  for (int i = 0; i < count; ++i)
    text += R"(, {"id": "i)" + std::to_string(i) + R"(", "kind": "operation", "operation": "x)" +
            std::to_string(i) + R"(", "next": "j)" + std::to_string(i) + R"("})";
  return text + "]}";
}

/// Reads and checks the text, and looks for its ways. Gives the seconds of this thread.
double seconds_of(const std::string& text, Diagnostics& diagnostics, Ways& ways) {
  MemoryFileSystem files;
  files.add("o.op.json", text);
  SourceManager sources;
  const std::clock_t begin = std::clock();
  const auto program = load(files, sources, "o.op.json", diagnostics);
  REQUIRE(program);
  CHECK(check_shape(*program, diagnostics));
  if (!diagnostics.has_errors()) {
    CHECK(check_cell(*program, {going(), {}, {}, {}, {}}, diagnostics));
    ways = ways_through(*program, going(), {{{{"go", 0}, std::chrono::seconds(1)}}});
  }
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

// Twice the figures that are asked for: the processor may be busy, and sanitizers are slow.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
constexpr double slower = 20;
#else
constexpr double slower = 2;
#endif

}  // namespace

TEST_CASE("checks of great operations take little time") {
  Diagnostics diagnostics;
  Ways ways;
  SECTION("10,000 icons") {
    CHECK(seconds_of(many_icons(10'000), diagnostics, ways) < 0.5 * slower);
    CHECK_FALSE(diagnostics.has_errors());
  }
  SECTION("a chain of 4,000 sub-operations") {
    CHECK(seconds_of(nested(4'000, 1), diagnostics, ways) < 0.5 * slower);
    REQUIRE(ways.ways.size() == 2);
    CHECK(ways.ways.front().end == "exit end with code 0");
    CHECK(ways.ways.front().longest == Duration(std::chrono::seconds(1)));
  }
  SECTION("1,000 MERGEs that a thousand skills lead to") {
    CHECK(seconds_of(many_merges(1'000), diagnostics, ways) < 0.1 * slower);
    CHECK(diagnostics.all().size() == 1);  // the code 7 never comes
  }
  SECTION("30 levels with two uses each") {
    CHECK(seconds_of(nested(30, 2), diagnostics, ways) < 0.1 * slower);
    REQUIRE_FALSE(ways.ways.empty());
    CHECK(ways.ways.front().longest == Duration(std::chrono::seconds(std::int64_t{1} << 30)));
  }
  SECTION("20,000 wrong names") {
    CHECK(seconds_of(all_wrong(10'000), diagnostics, ways) < 0.5 * slower);
    CHECK(diagnostics.errors() == 20'000);
  }
}

TEST_CASE("a stop ends the checks, which say so") {
  const auto program = test::program_of(many_icons(100));
  Diagnostics diagnostics;
  std::size_t asked = 0;
  const Stop at_once = [] { return true; };
  const Stop later = [&asked] { return ++asked > 50; };
  CHECK_FALSE(check_shape(program, diagnostics, at_once));
  CHECK_FALSE(check_cell(program, {going(), {}, {}, {}, {}}, diagnostics, at_once));
  CHECK_FALSE(check_cell(program, {going(), {}, {}, {}, {}}, diagnostics, later));
  CHECK_FALSE(ways_through(program, going(), {}, 64, later).complete);
  CHECK(diagnostics.all().empty());
}

TEST_CASE("circles are found, and those that lead to themselves") {
  CHECK(circles({{1}, {2}, {0, 3}, {3}, {5}, {}}) == std::vector<std::vector<std::size_t>>{{3}, {0, 1, 2}});
  CHECK(circles({{1, 2}, {2}, {}}).empty());
}
