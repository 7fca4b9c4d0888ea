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
        "ready at start after 0 steps; last code 0\n"
        "paused before a after 1 step; last code 1\n"
        "paused before a after 1 step; last code 1\n"
        "paused after 2 steps: breakpoint at b; last code 0\n");
  CHECK(std::get<double>(runner.last_parameters.at(0).value) == 5);
  CHECK(runner.ran.size() == 2);
}

TEST_CASE("a line that cannot be obeyed is answered and changes nothing") {
  test::ScriptedRunner runner;
  const std::string text = answers("jump\nbreak x\nset a far\nfrom y\nbreak b many\n", runner);
  for (const char* why : {"no command 'jump'", "has no icon 'x'", "write set ICON PARAMETER VALUE",
                          "has no icon 'y'", "'many' is no completion code"})
    CHECK(text.find(why) != std::string::npos);
  CHECK(runner.ran.empty());
}
