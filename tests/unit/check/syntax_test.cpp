#include <catch2/catch.hpp>
#include <sstream>

#include "pal/syntax/parse.hpp"
#include "pal/syntax/print.hpp"
#include "tests/unit/check/specification.hpp"

using namespace pal;

namespace {

struct Parsed {
  SourceManager sources;
  Diagnostics diagnostics;
  syntax::Tree tree;
};

Parsed parse(const std::string& text) {
  Parsed result;
  const auto file = result.sources.add("a.pal", text);
  result.tree = syntax::parse(result.sources, file, result.diagnostics);
  return result;
}

std::string printed(const syntax::Tree& tree) {
  std::ostringstream out;
  syntax::print(tree, out);
  return out.str();
}

}  // namespace

TEST_CASE("printing a tree and parsing that gives the same text again") {
  for (const auto* path :
       {"skills_pal/workcell.pal", "skills_pal/touch/touch.pal", "skills_pal/modules/z_force.pal",
        "skills_pal/modules/alter.pal", "skills_pal/touch/touch_read_first.pal",
        "tests/golden/check/figure_3_6.pal", "tests/golden/check/wait_forms.pal",
        "tests/golden/check/environment.pal", "tests/golden/check/words_as_names.pal"}) {
    CAPTURE(path);
    const auto first = parse(test::source_file(path));
    REQUIRE(first.tree.complete);
    const auto text = printed(first.tree);
    const auto second = parse(text);
    REQUIRE(second.tree.complete);
    CHECK(printed(second.tree) == text);
  }
}

TEST_CASE("a request is the same in both orders, and kind words are kept apart") {
  const auto parsed =
      parse("Skill Module: SM1\nBEGIN\n  WTM( motion request from machine controller MC1 )\nEND\n");
  REQUIRE(parsed.tree.complete);
  const auto& module = std::get<syntax::ModuleUnit>(parsed.tree.units.at(0));
  const auto& wait = std::get<syntax::Wait>(module.body.at(0).content);
  CHECK(wait.source.message.request);
  CHECK(wait.source.message.name.text == "motion");
  CHECK(wait.source.from.kind == pan::ModuleKind::machine_controller);
  CHECK(wait.source.from.name.text == "MC1");
  CHECK(parsed.sources.text(wait.source.from.where) == "machine controller MC1");
}

TEST_CASE("places are bytes, also after a byte order mark and wide characters") {
  const auto parsed = parse("\xEF\xBB\xBF# \xE5\x8A\x9B\nDEVICE d \"\xE5\x8A\x9B\"\nDEVICE e\n");
  REQUIRE(parsed.tree.complete);
  const auto& device = std::get<syntax::DeviceUnit>(parsed.tree.units.at(1));
  CHECK(parsed.sources.text(device.name.where) == "e");
  CHECK(parsed.sources.line_column(device.name.where.file, device.name.where.begin).line == 3);
}

TEST_CASE("hostile texts end with a finding, not with the program") {
  const auto findings = [](const std::string& text) {
    auto parsed = parse(text);
    return parsed.diagnostics.errors();
  };
  CHECK(findings(std::string(100'000, '(')) >= 1);
  CHECK(findings("Skill Module: M\nBEGIN\n" + std::string(2'000'000, 'x') + "\nEND\n") == 0);
  CHECK(findings("Skill Module: M BEGIN CASE (" + std::string(100'000, '(') + "a" +
                 std::string(100'000, ')')) >= 1);
  std::string nots = "Skill Module: M\nBEGIN\nREPEAT\nUNTIL( ";
  for (int i = 0; i < 50'000; ++i) nots += "NOT ";
  CHECK(findings(nots + "a )\nEND\n") == 0);
  std::string deep = "Skill Module: M\nBEGIN\n";
  for (int i = 0; i < syntax::deepest_nesting - 2; ++i) deep += "REPEAT\n";
  for (int i = 0; i < syntax::deepest_nesting - 2; ++i) deep += "UNTIL( a )\n";
  CHECK(findings(deep + "END\n") == 0);
  CHECK(test::check_text(deep + "END\n").diagnostics.errors() == 2);  // nothing sets a, so nothing ends
  std::string ends;
  for (int i = 0; i < 20'000; ++i) ends += "END CASE\n";
  CHECK(findings(ends) >= 1);
  CHECK(findings(std::string(10'000, '"')) >= 1);
  CHECK(findings(std::string(100'000, '$')) == 1);
}
