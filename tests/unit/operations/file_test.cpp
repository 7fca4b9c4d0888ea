// What is written can be read, and says the same.
#include <sstream>
#include <utility>

#include "operations/parse.hpp"
#include "operations/write.hpp"
#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;

namespace {

std::optional<Document> document_of(const std::string& text, Diagnostics& diagnostics) {
  SourceManager sources;
  return parse(sources, sources.add("o.op.json", text), diagnostics);
}

}  // namespace

TEST_CASE("a document that is written and read is the same") {
  Document document;
  Operation operation;
  operation.name = "all, \"kinds\": \\";
  operation.description = "With ä and a line\nbreak.";
  Icon skill;
  skill.id = "s";
  skill.kind = IconKind::skill;
  skill.skill = "go";
  skill.parameters = {{"a", 0.1, {}, {}},
                      {"b", true, {}, {}},
                      {"c", std::string("x: y, \"z\""), {}, {}},
                      {"d", -3.0, {}, {}}};
  skill.next.icon = "c";
  skill.error.icon = "x";
  skill.at = Point{1.5, -2};
  skill.note = "A note.";
  Icon branch;
  branch.id = "c";
  branch.kind = IconKind::branch;
  branch.ways = {{{0, 1}, {"s", {}}, {}}, {{-2}, {"x", {}}, {}}};
  branch.otherwise.icon = "x";
  Icon wait;
  wait.id = "w";
  wait.kind = IconKind::delay;
  wait.seconds = Amount{0.25};
  wait.next.icon = "s";
  Icon leave;
  leave.id = "x";
  leave.kind = IconKind::exit;
  leave.code = Amount{3};
  Icon look;
  look.id = "t";
  look.kind = IconKind::test;
  look.conditions = {Condition{"eye"}};
  look.limits = {Amount{-1}, Amount{2.5}};
  look.next.icon = "c";
  look.error.icon = "x";
  Icon until;
  until.id = "u";
  until.kind = IconKind::wait;
  until.conditions = {Condition{"eye", {}, Amount{1}, Amount{2}}};
  until.timeout = Amount{0.5};
  until.next.icon = "x";
  operation.icons = {skill, branch, wait, leave, look, until};
  document.operations = {operation, operation};
  document.operations[1].name = "second";

  const std::string text = write(document);
  Diagnostics diagnostics;
  const auto again = document_of(text, diagnostics);
  REQUIRE(again);
  CHECK_FALSE(diagnostics.has_errors());
  CHECK(write(*again) == text);
  const Icon& read_skill = again->operations[0].icons[0];
  CHECK(again->operations[0].name == operation.name);
  CHECK(again->operations[0].description == operation.description);
  CHECK(std::get<double>(read_skill.parameters[0].value) == 0.1);
  CHECK(std::get<std::string>(read_skill.parameters[2].value) == "x: y, \"z\"");
  CHECK(again->operations[1].icons[1].ways[0].codes == std::vector<int>{0, 1});
  CHECK(again->operations[1].icons[2].seconds->number == 0.25);
  CHECK(again->operations[1].icons[4].limits.at(1).number == 2.5);
  CHECK(again->operations[1].icons[4].error.icon == "x");
  CHECK(again->operations[1].icons[5].conditions.at(0).at_least->number == 1);
  CHECK(again->operations[1].icons[5].conditions.at(0).at_most->number == 2);
  CHECK(again->operations[1].icons[5].timeout->number == 0.5);
}

TEST_CASE("places are those of the text") {
  const std::string text = test::operation(
      R"({"id": "a", "kind": "skill", "skill": "g\"o", "parameters": {"n":-1.5e1, "t":true}, "next": "a"})");
  SourceManager sources;
  Diagnostics diagnostics;
  const auto document = parse(sources, sources.add("o.op.json", text), diagnostics);
  REQUIRE(document);
  const Icon& icon = document->operations[0].icons[1];
  CHECK(sources.text(icon.where) == "\"a\"");
  CHECK(sources.text(icon.subject) == R"("g\"o")");
  CHECK(sources.text(icon.parameters[0].where) == "-1.5e1");
  CHECK(sources.text(icon.parameters[0].name_where) == "\"n\"");
  CHECK(sources.text(icon.parameters[1].where) == "true");
  CHECK(sources.text(icon.next.where) == "\"a\"");
}

TEST_CASE("no text makes the reader crash") {
  const std::string whole = test::operation(test::looping);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    Diagnostics diagnostics;
    document_of(whole.substr(0, length), diagnostics);
    CHECK(diagnostics.has_errors());
  }
  for (const std::string text : {"[]", "7", "\"x\"", "null", "[[", "{}", "{\"a\":1e999}"}) {
    Diagnostics diagnostics;
    document_of(text, diagnostics);
    CHECK(diagnostics.has_errors());
  }
  Diagnostics deep;
  CHECK_FALSE(document_of(std::string(100'000, '['), deep));
  CHECK(deep.has_errors());
}

TEST_CASE("a sub-operation in another file is found relative to the file that names it") {
  MemoryFileSystem files;
  files.add("a/main.op.json",
            test::operation(R"({"id": "a", "kind": "operation", "file": "../b/part.op.json", "next": "a"})"));
  files.add(
      "b/part.op.json",
      R"({"operation-format": 1, "name": "part", "icons": [{"id": "s", "kind": "start", "next": "x"}, {"id": "x", "kind": "exit"}]})");
  SourceManager sources;
  Diagnostics diagnostics;
  const auto program = load(files, sources, "a/main.op.json", diagnostics);
  REQUIRE(program);
  REQUIRE(program->operations.size() == 2);
  CHECK(find_sub_operation(*program, program->operations[0], program->operations[0].icons[1]) == 1U);

  files.add("a/main.op.json",
            test::operation(R"({"id": "a", "kind": "operation", "file": "gone.op.json", "next": "a"})"));
  Diagnostics missing;
  load(files, sources, "a/main.op.json", missing);
  CHECK(missing.errors() == 1);
}

TEST_CASE("parameters have one order, whoever wrote them") {
  Icon one;
  one.id = "s";
  one.kind = IconKind::skill;
  one.skill = "go";
  one.parameters = {{"b", 1.0, {}, {}}, {"a", 2.0, {}, {}}};
  Icon other = one;
  std::swap(other.parameters[0], other.parameters[1]);
  const auto text_of = [](const Icon& icon) {
    Operation operation;
    operation.icons = {icon};
    Document document;
    document.operations = {operation};
    return write(document);
  };
  CHECK(text_of(one) == text_of(other));
  CHECK(text_of(one).find("{\"a\": 2, \"b\": 1}") != std::string::npos);
}

// A merge of lines joins changes only if there is a line between them that neither changes.
TEST_CASE("where an icon stands is not on a line beside what it does") {
  Operation operation;
  for (const char* id : {"one", "two"}) {
    Icon icon;
    icon.id = id;
    icon.kind = IconKind::exit;
    icon.at = Point{1, 2};
    operation.icons.push_back(icon);
  }
  Document document;
  document.operations = {operation};
  std::istringstream lines(write(document));
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  std::size_t places = 0;
  for (std::size_t n = 1; n + 1 < all.size(); ++n) {
    if (all[n].find("\"at\"") == std::string::npos) continue;
    ++places;
    CHECK(all[n].find("kind") == std::string::npos);
    CHECK(all[n - 1].find("kind") == std::string::npos);
    CHECK(all[n + 1].find("kind") == std::string::npos);
  }
  CHECK(places == 2);
}
