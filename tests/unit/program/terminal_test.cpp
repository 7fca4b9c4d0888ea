// Colours, and pages as a terminal shows them.
#include <cstdlib>

#include "programs/pal/session/colour.hpp"
#include "tests/unit/program/program.hpp"

namespace pal::test {
namespace {

/// A variable of the environment for as long as this lives.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) { ::setenv(name, value, 1); }
  ~Variable() { ::unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

}  // namespace

TEST_CASE("NO_COLOR, CLICOLOR_FORCE and a dumb terminal are obeyed") {
  const Variable terminal("TERM", "xterm");
  CHECK(program::wants_colour(true));
  CHECK_FALSE(program::wants_colour(false));
  {
    const Variable force("CLICOLOR_FORCE", "1");
    CHECK(program::wants_colour(false));
    const Variable none("NO_COLOR", "1");
    CHECK_FALSE(program::wants_colour(true));
  }
  {
    const Variable zero("CLICOLOR_FORCE", "0");
    CHECK_FALSE(program::wants_colour(false));
  }
  const Variable dumb("TERM", "dumb");
  CHECK_FALSE(program::wants_colour(true));
}

TEST_CASE("colours change nothing but colours") {
  const std::string text =
      "error[PAL0101]: unexpected 'x'\n --> a.pal:1:2\n  |\n1 | a x\n  |   ^\nhint: remove it\n1 - a x\n1 + "
      "a\n\n1 error\n";
  std::string bare;
  bool inside = false;
  for (const char c : program::coloured_findings(text)) {
    inside = inside || c == '\x1b';
    if (!inside) bare += c;
    if (c == 'm') inside = false;
  }
  CHECK(bare == text);
  CHECK(program::coloured_findings(text).find("\x1b[1;31merror[PAL0101]:") == 0);
  CHECK(program::coloured_table("  fails      quick\n").find("\x1b[1;31m  fails\x1b[0m") == 0);
}

TEST_CASE("a terminal shows a page without the marks of Markdown") {
  const std::string page =
      "## PAL0101\n\nA `word` that *nothing* expects, and so on until the line is longer than the terminal "
      "is wide.\n\n"
      "### Example\n\n```pal a.pal --quiet\nMESSAGE a\n```\n\n- one\n- two\n";
  const std::string shown = program::terminal_page(page, false, 60);
  CHECK(shown ==
        "PAL0101\n\nA word that nothing expects, and so on until the line is\nlonger than the terminal is "
        "wide.\n\n"
        "Example\n\n  a.pal --quiet:\n    MESSAGE a\n\n- one\n- two\n");
}

}  // namespace pal::test
