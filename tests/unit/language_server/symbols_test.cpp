// The table of names: every name of the shipped skills is in it, each with its declaration.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <set>
#include <string>

#include "pal/check/read_sources.hpp"
#include "pal/check/symbols.hpp"
#include "pal/support/file_system.hpp"
#include "pal/syntax/expected.hpp"
#include "pal/syntax/text_tokens.hpp"

using namespace pal;

TEST_CASE("every name of the shipped skills leads to its declaration") {
  const DiskFileSystem files;
  const auto paths = files.list(std::string(PAL_SOURCE_DIR) + "/skills_pal", ".pal");
  REQUIRE(paths);
  SourceManager sources;
  Diagnostics diagnostics;
  const auto trees = check::read_sources(files, sources, *paths, diagnostics);
  const auto symbols = check::symbols_of(trees);
  std::set<std::pair<FileId, std::uint32_t>> known;
  for (const auto& use : symbols.uses) {
    known.emplace(use.where.file, use.where.begin);
    CHECK(sources.text(use.where) == symbols.all[use.symbol].name);
  }
  std::size_t names = 0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const FileId file(i);
    const auto text = sources.text(file);
    std::string before;
    bool type = false;  // a type and its unit go on
    for (const auto& token : syntax::text_tokens(text)) {
      using Kind = syntax::TextToken::Kind;
      if (token.kind == Kind::comment) continue;
      const std::string word(text.substr(token.begin, token.end - token.begin));
      const bool is_unit =
          token.kind == Kind::name &&
          (std::isdigit(static_cast<unsigned char>(before.back())) != 0 || type || before == "]");
      type = word == "REAL" || word == "INTEGER" || (type && (word == "*" || word == "/" || word == "^")) ||
             (is_unit && type) || (is_unit && before == "]");
      if (token.kind == Kind::name && !is_unit) {
        ++names;
        INFO(sources.name(file) << ":" << sources.line_column(file, token.begin).line << ": " << word);
        CHECK(known.contains({file, token.begin}));
      }
      before = word;
    }
  }
  CHECK(names > 1000);
}

TEST_CASE("what may stand at a place") {
  const auto wanted = [](const std::string& text) { return syntax::expected_at(text, text.size()); };
  using syntax::Wanted;
  const auto has = [](const syntax::Expected& expected, Wanted sort) {
    return std::find(expected.wanted.begin(), expected.wanted.end(), sort) != expected.wanted.end();
  };
  const auto word = [](const syntax::Expected& expected, const std::string& keyword) {
    return std::find(expected.keywords.begin(), expected.keywords.end(), keyword) != expected.keywords.end();
  };
  const std::string module = "Skill Module: SM1\nBEGIN\n  WTM( Coordinator )\n";
  CHECK(word(wanted(""), "MESSAGE"));
  CHECK(word(wanted(module), "CASE"));
  CHECK(word(wanted(module), "END"));
  CHECK(has(wanted(module), Wanted::activity));
  CHECK(has(wanted(module + "  WTM( "), Wanted::message));
  CHECK(has(wanted(module + "  WTM( x from "), Wanted::sender));
  CHECK(has(wanted(module + "  TXM( x to M"), Wanted::receiver));
  CHECK(has(wanted(module + "  TXM( request x from "), Wanted::asked));
  CHECK(has(wanted(module + "  SPC( "), Wanted::condition));
  CHECK(word(wanted(module + "  CASE\n    ( c ):\n"), "END CASE"));
  CHECK(has(wanted("ENVIRONMENT e\n  PROCESSOR P0\n  PLACE SM1 ON "), Wanted::processor));
  CHECK(has(wanted("ENVIRONMENT e\n  TIME hold OF LS1 : 4 "), Wanted::time_unit));
  CHECK(has(wanted("SKILL s\n  SENSOR DRIVER "), Wanted::sensor_driver));
  CHECK(word(wanted("SKILL s\n  "), "END SKILL"));
  // A mistake further up.
  CHECK(has(wanted("Skill Module: SM1\nBEGIN\n  WTM( , )\n  WTM( x from "), Wanted::sender));
}
