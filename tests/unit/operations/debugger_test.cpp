#include "operations/debugger.hpp"

#include <sstream>

#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;

namespace {

std::string answers(const std::string& lines, test::ScriptedRunner& runner) {
  Executor executor(test::program_of(test::operation(test::looping)), runner);
  std::istringstream in(lines);
  std::ostringstream out;
  debug(executor, in, out);
  return out.str();
}

}  // namespace

TEST_CASE("an operation is run by hand") {
  test::ScriptedRunner runner;
  runner.codes = {1, 0};
  CHECK(answers("break b\nstep\nset a far 5\nrun\nquit\nrun\n", runner) ==
        "ready at start after 0 steps; last code 0\n"
        "  break b\n"
        "ready at start after 0 steps; last code 0\n"
        "paused before a after 1 step; last code 1\n"
        "a: far is 5 now, before it was 3\n"
        "paused before a after 1 step; last code 1\n"
        "paused after 2 steps: breakpoint at b; last code 0\n");
  CHECK(std::get<double>(runner.last_parameters.at(0).value) == 5);
  CHECK(runner.ran.size() == 2);
}

TEST_CASE("breakpoints are listed") {
  test::ScriptedRunner runner;
  CHECK(answers("break\nbreak b 1\nbreak a\nclear\nbreak\nset b near true\n", runner) ==
        "ready at start after 0 steps; last code 0\n"
        "no breakpoints\n"
        "  break b 1\n"
        "ready at start after 0 steps; last code 0\n"
        "  break b 1\n"
        "  break a\n"
        "ready at start after 0 steps; last code 0\n"
        "ready at start after 0 steps; last code 0\n"
        "no breakpoints\n"
        "b: near is true now, before it was the default\n"
        "ready at start after 0 steps; last code 0\n");
}

TEST_CASE("a list of nested operations ends") {
  std::string text = R"({"operation-format": 1, "name": "o0", "icons": [)";
  std::string others;
  const auto icons = [](int level) {
    const std::string next = R"("operation": "o)" + std::to_string(level + 1) + "\"";
    return R"({"id": "s", "kind": "start", "next": "a"}, )" +
           (level == 30 ? std::string(R"({"id": "a", "kind": "delay", "seconds": 1, "next": "e"})")
                        : R"({"id": "a", "kind": "operation", )" + next + R"(, "next": "b"}, )" +
                              R"({"id": "b", "kind": "operation", )" + next + R"(, "next": "e"})") +
           R"(, {"id": "e", "kind": "exit"}])";
  };
  for (int level = 1; level <= 30; ++level)
    others += (level == 1 ? "" : ", ") + (R"({"name": "o)" + std::to_string(level)) + R"(", "icons": [)" +
              icons(level) + "}";
  test::ScriptedRunner runner;
  Executor executor(test::program_of(text + icons(0) + R"(, "operations": [)" + others + "]}"), runner);
  std::istringstream in("list\n");
  std::ostringstream out;
  debug(executor, in, out);
  CHECK(out.str().size() < 100'000);
  CHECK(out.str().find("… and more") != std::string::npos);
}

TEST_CASE("a line that cannot be obeyed is answered and changes nothing") {
  test::ScriptedRunner runner;
  const std::string text = answers("jump\nbreak x\nset a far\nfrom y\nbreak b many\n", runner);
  for (const char* why : {"no command 'jump'", "has no icon 'x'", "write set ICON PARAMETER VALUE",
                          "has no icon 'y'", "'many' is no completion code"})
    CHECK(text.find(why) != std::string::npos);
  CHECK(runner.ran.empty());
}
