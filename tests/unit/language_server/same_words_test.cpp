// A hover and a command say the same of the same thing.
#include "tests/unit/language_server/client.hpp"
#include "tests/unit/program/program.hpp"

using namespace pal;
using namespace pal::language_server::test;

namespace {

const std::map<std::string, std::string> files{
    {"/w/shared.pal", shared}, {"/w/feel.pal", skill}, {"/w/cell.pal", cell}};

std::string command(const std::vector<std::string>& arguments) {
  const auto answer = pal::test::pal(arguments, MemoryFileSystem(files));
  INFO(answer.err);
  return answer.out + answer.err;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream rest(text);
  for (std::string line; std::getline(rest, line);) lines.push_back(line);
  return lines;
}

/// The cells of a line "| a | b |".
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t at = line.find("| "); at != std::string::npos && at + 2 < line.size();) {
    const auto end = line.find(" |", at + 1);
    if (end == std::string::npos) break;
    cells.push_back(end < at + 2 ? "" : line.substr(at + 2, end - at - 2));
    at = end + 1;
  }
  return cells;
}

/// What a table of the document says of a thing, by the heads of its columns; empty cells are left out.
std::map<std::string, std::string> row_of(const std::string& document, const std::string& table,
                                          const std::string& thing) {
  std::vector<std::string> heads;
  std::map<std::string, std::string> row;
  for (const auto& line : lines_of(document)) {
    if (line.starts_with("| " + table + " |")) heads = cells_of(line);
    if (line.empty()) heads.clear();
    const auto cells = cells_of(line);
    if (heads.empty() || cells.empty() || cells.front() != "`" + thing + "`") continue;
    REQUIRE(cells.size() == heads.size());
    for (std::size_t i = 1; i < cells.size(); ++i) {
      if (!cells[i].empty()) row[heads[i]] = cells[i];
    }
  }
  return row;
}

/// The lines "- head: words" of a hover.
std::map<std::string, std::string> facts_of(const std::string& hover) {
  std::map<std::string, std::string> facts;
  for (const auto& line : lines_of(hover)) {
    const auto colon = line.find(": ");
    if (line.starts_with("- ") && colon != std::string::npos)
      facts[line.substr(2, colon - 2)] = line.substr(colon + 2);
  }
  return facts;
}

/// What a hover at the place of a word says.
std::string hover(const std::string& file, const std::string& text, const std::string& word) {
  Client client;
  client.open(file, text);
  const int asked = client.ask_at("textDocument/hover", file, word);
  client.run();
  return client.result(asked)["contents"]["value"];
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a hover on a name says what pal doc says") {
  const std::string document = command({"doc", "/w/feel.pal"});
  struct Thing {
    const char* table;
    const char* name;
    std::string told;
    std::size_t facts;
  };
  const std::vector<Thing> things{{"Message", "force", hover("shared.pal", shared, "force : REAL"), 2},
                                  {"Condition", "pressed", hover("shared.pal", shared, "pressed FROM"), 3},
                                  {"Activity", "look", hover("feel.pal", skill, "look READS"), 2}};
  for (const auto& thing : things) {
    INFO(thing.name << "\n" << document << thing.told);
    const auto row = row_of(document, thing.table, thing.name);
    CHECK(row.size() == thing.facts);
    const auto facts = facts_of(thing.told);
    for (const auto& [head, words] : row) {
      INFO(head);
      REQUIRE(facts.contains(head));
      CHECK(facts.at(head) == words);
    }
  }
  const std::string driver = "`SD1`. It drives `cell`, measures forces";
  CHECK(has(document, "- " + driver));
  CHECK(has(hover("shared.pal", shared, "SD1\nBEGIN"), driver));
}

TEST_CASE("a hover on a finding says what pal explain says") {
  const std::vector<std::tuple<std::string, std::string, std::string>> mistakes{
      {"PAL0202", replaced(skill, "WTM( force from LS1 )", "WTM( forse from LS1 )"), "forse"},
      {"PAL0301", replaced(skill, "TXM( request force from LS1 )", "TXM( request force from SD1 )"),
       "force from SD1"},
      {"PAL0890", replaced(skill, "AT MOST 20 ms", "AT MOST 4 ms"), "soon"}};
  for (const auto& [code, text, word] : mistakes) {
    INFO(code);
    const auto page = lines_of(command({"explain", code}));
    REQUIRE(page.size() > 4);
    const std::string told = hover("feel.pal", text, word);
    INFO(told);
    CHECK(has(told, "`" + code + "`"));
    CHECK(has(told, "**" + page[2].substr(page[2].find(": ") + 2)));  // "**error: …**"
    std::string paragraph;
    for (std::size_t i = 4; i < page.size() && !page[i].empty(); ++i)
      paragraph += (paragraph.empty() ? "" : " ") + page[i];
    CHECK(has(told, paragraph));
  }
}

TEST_CASE("a hover on a requirement says what pal check says") {
  const std::string told = hover("feel.pal", skill, "soon");
  const std::string checked = command({"check", "/w/feel.pal", "-e", "/w/cell.pal", "--explain"});
  INFO(checked << told);
  CHECK(has(checked, "holds      soon  duration to completion 0         5 ms  of   20 ms"));
  CHECK(has(told, "duration to completion 0 in cell-one: **holds**, 5 ms of 20 ms"));
  int parts = 0;
  for (const auto& line : lines_of(checked)) {  // "+ 3 ms  SM1 runs look  (feel.pal:19)"
    const auto plus = line.find("+ ");
    if (plus == std::string::npos) continue;
    const auto what = line.find("  ", plus), where = line.find("  (", plus);
    REQUIRE(where != std::string::npos);
    ++parts;
    CHECK(has(told, line.substr(plus + 2, what - plus - 2) + ": " + line.substr(what + 2, where - what - 2)));
  }
  CHECK(parts == 2);
}
