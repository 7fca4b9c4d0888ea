// Changes of a program's text: exactly the lines that move, move.
#include "pal/rewrite/rewrite.hpp"

#include <catch2/catch.hpp>

#include "pal/support/edit.hpp"
#include "pal/syntax/parse.hpp"

using namespace pal;
using rewrite::Rewriting;

namespace {

/// A module around these statements, each on a line.
std::string module_with(const std::string& body) {
  return "Skill Module: SM1\nBEGIN\n" + body + "END\n";
}

struct Parsed {
  SourceManager sources;
  Diagnostics diagnostics;
  syntax::Tree tree;
  FileId file;

  explicit Parsed(const std::string& body) : file(sources.add("m.pal", module_with(body))) {
    tree = syntax::parse(sources, file, diagnostics);
    REQUIRE_FALSE(diagnostics.has_errors());
  }
  std::string after(const Rewriting& change) const { return apply(change.edits, file, sources.text(file)); }
};

}  // namespace

TEST_CASE("a wait behind the read of a condition comes before it") {
  const Parsed parsed(
      "  RPC( near )\n"
      "  RPC( far )\n"
      "  WTM( request motion from MC1 )  # the robot's\n"
      "  Do Nothing\n");
  const auto found = rewrite::read_after_wait(parsed.tree, parsed.sources.text(parsed.file));
  REQUIRE(found.size() == 1);
  CHECK(found[0].title == "wait for request motion before reading near, far");
  CHECK(found[0].module == "SM1");
  CHECK(
      parsed.after(found[0]).starts_with("Skill Module: SM1\nBEGIN\n"
                                         "  WTM( request motion from MC1 )\n"
                                         "  RPC( near )\n"
                                         "  RPC( far )\n"));
}

TEST_CASE("a wait at the beginning of an arm moves before the CASE") {
  const Parsed parsed(
      "  RPC( near )\n"
      "  CASE\n"
      "    ( near ):\n"
      "      Do Nothing\n"
      "    ( NOT near ):\n"
      "      WTM( motion request from MC1 )\n"
      "      advance\n"
      "  END CASE\n");
  const auto found = rewrite::read_after_wait(parsed.tree, parsed.sources.text(parsed.file));
  REQUIRE(found.size() == 1);
  CHECK(parsed.after(found[0]) == module_with("  WTM( motion request from MC1 )\n"
                                              "  RPC( near )\n"
                                              "  CASE\n"
                                              "    ( near ):\n"
                                              "      Do Nothing\n"
                                              "    ( NOT near ):\n"
                                              "      advance\n"
                                              "  END CASE\n"));
}

TEST_CASE("an arm that only waited does nothing afterwards") {
  const Parsed parsed(
      "  CASE\n"
      "    ( near ):\n"
      "      WTM( tick from MC1 )\n"
      "    ( NOT near ):\n"
      "      advance\n"
      "  END CASE\n");
  const auto found = rewrite::read_after_wait(parsed.tree, parsed.sources.text(parsed.file));
  REQUIRE(found.size() == 1);
  CHECK(parsed.after(found[0]) == module_with("  WTM( tick from MC1 )\n"
                                              "  CASE\n"
                                              "    ( near ):\n"
                                              "      Do Nothing\n"
                                              "    ( NOT near ):\n"
                                              "      advance\n"
                                              "  END CASE\n"));
}

TEST_CASE(
    "arms that wait for different messages stay as they are, and so does a read that follows its wait") {
  const Parsed parsed(
      "  WTM( tick from MC1 )\n"
      "  RPC( near )\n"
      "  CASE\n"
      "    ( near ):\n"
      "      WTM( tick from MC1 )\n"
      "    ( NOT near ):\n"
      "      WTM( tock from MC1 )\n"
      "  END CASE\n");
  CHECK(rewrite::read_after_wait(parsed.tree, parsed.sources.text(parsed.file)).empty());
}

TEST_CASE("a wait behind sensing comes before the request") {
  const Parsed parsed(
      "  REPEAT\n"
      "    TXM( request depth from Level )\n"
      "    WTM( depth from Level )\n"
      "    filter\n"
      "    SPC( wet )\n"
      "    SPC( warm )\n"
      "    WTM( tick from Axis )\n"
      "    lower\n"
      "  UNTIL( wet )\n");
  const auto found = rewrite::set_after_wait(parsed.tree, parsed.sources.text(parsed.file));
  REQUIRE(found.size() == 1);
  CHECK(found[0].title == "wait for tick before sensing wet, warm");
  CHECK(parsed.after(found[0]) == module_with("  REPEAT\n"
                                              "    WTM( tick from Axis )\n"
                                              "    TXM( request depth from Level )\n"
                                              "    WTM( depth from Level )\n"
                                              "    filter\n"
                                              "    SPC( wet )\n"
                                              "    SPC( warm )\n"
                                              "    lower\n"
                                              "  UNTIL( wet )\n"));
}

TEST_CASE("a wait moves before the wait for what comes unasked, and not where nothing is set from it") {
  const Parsed parsed(
      "  TXM( request other from Level )\n"
      "  WTM( depth from Level )\n"
      "  SPC( wet )\n"
      "  WTM( tick from Axis )\n"
      "  WTM( tock from Axis )\n"
      "  SPC( dry = TRUE )\n"
      "  REPEAT\n"
      "    SPC( dry )\n"
      "    WTM( tick from Axis )\n"
      "  UNTIL( forever )\n");
  const auto found = rewrite::set_after_wait(parsed.tree, parsed.sources.text(parsed.file));
  REQUIRE(found.size() == 1);
  CHECK(
      parsed.after(found[0]).starts_with("Skill Module: SM1\nBEGIN\n"
                                         "  TXM( request other from Level )\n"
                                         "  WTM( tick from Axis )\n"
                                         "  WTM( depth from Level )\n"
                                         "  SPC( wet )\n"
                                         "  WTM( tock from Axis )\n"));
}

TEST_CASE("courier: a request before the loop, and one behind each answer") {
  const Parsed parsed(
      "  REPEAT\n"
      "    WTM( request edge from Watch )\n"
      "    TXM( request profile from RF )\n"
      "    WTM( profile from RF )  # a scan\n"
      "    interpret\n"
      "    TXM( edge to Watch )\n"
      "  UNTIL( forever )\n");
  const auto found = rewrite::ask_ahead(parsed.tree, parsed.sources.text(parsed.file));
  REQUIRE(found.size() == 1);
  CHECK(found[0].title == "ask RF for the next profile as soon as the last one is there (a courier)");
  CHECK(parsed.after(found[0]) == module_with("  TXM( request profile from RF )\n"
                                              "  REPEAT\n"
                                              "    WTM( request edge from Watch )\n"
                                              "    WTM( profile from RF )  # a scan\n"
                                              "    TXM( request profile from RF )\n"
                                              "    interpret\n"
                                              "    TXM( edge to Watch )\n"
                                              "  UNTIL( forever )\n"));
}

TEST_CASE("a loop that asks ahead already, or asks twice, is left alone") {
  const Parsed ahead(
      "  TXM( request profile from RF )\n"
      "  REPEAT\n"
      "    WTM( profile from RF )\n"
      "    TXM( request profile from RF )\n"
      "  UNTIL( forever )\n");
  CHECK(rewrite::ask_ahead(ahead.tree, ahead.sources.text(ahead.file)).empty());
  const Parsed twice(
      "  REPEAT\n"
      "    TXM( request profile from RF )\n"
      "    WTM( profile from RF )\n"
      "    TXM( request profile from RF )\n"
      "    WTM( profile from RF )\n"
      "  UNTIL( forever )\n");
  CHECK(rewrite::ask_ahead(twice.tree, twice.sources.text(twice.file)).empty());
}
