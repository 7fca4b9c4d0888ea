#include "operations/storyboard.hpp"

#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;

TEST_CASE("a storyboard tells scenes, and branches by code") {
  Skills skills;
  pan::Completion done, none;
  done.description = "It is there.";
  none.code = 1;
  none.kind = pan::Completion::Kind::contingency;
  none.description = "The way <was> shut.";
  skills["go"].descriptions = {"Goes there."};
  skills["go"].preconditions = {"The way is free."};
  skills["go"].postconditions = {"It stands still."};
  skills["go"].completions = {done, none};
  const auto program = test::program_of(test::operation(test::looping));
  CHECK(storyboard_markdown(program, skills) ==
        "# o\n\nIt begins with scene 1, a.\n\n### Scene 1: a\n\nBefore: The way is free.\n\n"
        "The skill go runs, with far 3. Goes there.\n\nAfterwards, if the code is normal: It stands still.\n\n"
        "- Code 0 (It is there): on to scene 2, b.\n"
        "- Code 1 (The way \\<was\\> shut): on to scene 1, a.\n\n"
        "### Scene 2: b\n\nThe skill back runs. Nothing is known of it.\n\n"
        "- Code 0: the operation ends with code 0.\n");
  const std::string page = storyboard_html(program, skills);
  CHECK(page.find("The way &lt;was&gt; shut") != std::string::npos);
  CHECK(page.find("<svg") != std::string::npos);
  CHECK(page.find("<?xml") == std::string::npos);
}
