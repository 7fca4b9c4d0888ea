#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "pal/support/diagnostic_code.hpp"
#include "pal/support/render.hpp"

using namespace pal;

TEST_CASE("findings are sorted by place, and repeats told once") {
  SourceManager sources;
  const auto file = sources.add("a.pal", "one\ntwo\n");
  Diagnostics diagnostics;
  diagnostics.report(Code::PAL0201, {file, 4, 7}, "second");
  diagnostics.report(Code::PAL0201, {file, 0, 3}, "first");
  diagnostics.report(Code::PAL0201, {file, 4, 7}, "second");
  diagnostics.report(Code::PAL0209, {}, "nowhere");
  const auto sorted = diagnostics.sorted();
  REQUIRE(sorted.size() == 3);
  CHECK(sorted[0].message == "nowhere");
  CHECK(sorted[1].message == "first");
  CHECK(sorted[2].message == "second");
  CHECK(diagnostics.errors() == 3);
}

TEST_CASE("the JSON form has every part of a finding") {
  SourceManager sources;
  const auto file = sources.add("a.pal", "one\ntwo\n");
  Diagnostics diagnostics;
  auto& finding = diagnostics.report(Code::PAL0201, {file, 4, 7}, "there is no \"two\"", "try three");
  finding.notes.push_back({{file, 0, 3}, "see"});
  const auto json = nlohmann::json::parse(render_json(diagnostics.sorted(), sources));
  REQUIRE(json.size() == 1);
  CHECK(json[0]["code"] == "PAL0201");
  CHECK(json[0]["severity"] == "error");
  CHECK(json[0]["file"] == "a.pal");
  CHECK(json[0]["line"] == 2);
  CHECK(json[0]["column"] == 1);
  CHECK(json[0]["end_column"] == 4);
  CHECK(json[0]["message"] == "there is no \"two\"");
  CHECK(json[0]["hint"] == "try three");
  CHECK(json[0]["notes"][0]["line"] == 1);
  CHECK(render_json({}, sources) == "[]");
}

TEST_CASE("of a very long line only the part around the place is shown") {
  SourceManager sources;
  const auto file = sources.add("a.pal", std::string(1'000'000, 'x') + "HERE" + std::string(1'000'000, 'y'));
  Diagnostics diagnostics;
  diagnostics.report(Code::PAL0101, {file, 1'000'000, 1'000'004}, "this");
  std::ostringstream out;
  render_text(diagnostics.sorted(), sources, out);
  CHECK(out.str().size() < 1000);
  CHECK(out.str().find("xHERE") != std::string::npos);
  CHECK(out.str().find(" ^^^^\n") != std::string::npos);
}

namespace {

struct Many {
  SourceManager sources;
  Diagnostics diagnostics;
  FileId file = sources.add("a.pal", std::string(200'000, 'x'));

  void report(Code code, std::size_t count, std::uint32_t begin) {
    for (std::size_t i = 0; i < count; ++i, ++begin)
      diagnostics.report(code, {file, begin, begin + 1}, "finding");
  }
  std::string text(std::size_t most) const {
    std::ostringstream out;
    render_text(diagnostics.sorted(), sources, out, {most, diagnostics.not_kept()});
    return out.str();
  }
};

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("so many findings are shown, errors before warnings, and all are counted") {
  Many many;
  many.report(Code::PAL0209, 6, 0);
  many.report(Code::PAL0201, 5, 100);
  const auto seven = many.text(7);
  CHECK(occurrences(seven, "error[PAL0201]") == 5);
  CHECK(occurrences(seven, "warning[PAL0209]") == 2);
  CHECK(seven.ends_with("\n\n\u2026 and 4 more; --max-errors 0 shows all\n\n5 errors, 6 warnings\n"));
  CHECK(seven.find("warning[") < seven.find("error["));  // in the order of the text
  const auto three = many.text(3);
  CHECK(occurrences(three, "error[") == 3);
  CHECK(occurrences(three, "warning[") == 0);
  CHECK(three.ends_with("\u2026 and 8 more; --max-errors 0 shows all\n\n5 errors, 6 warnings\n"));
  for (const std::size_t all : {0, 11, 12}) {
    CHECK(occurrences(many.text(all), "[PAL02") == 11);
    CHECK(many.text(all).find("more") == std::string::npos);
  }
}

TEST_CASE("findings beyond the limit of their severity are counted and not kept") {
  constexpr auto most = Diagnostics::most_kept;
  Many many;
  many.report(Code::PAL0209, most + 7, 0);
  CHECK_FALSE(many.diagnostics.has_errors());
  many.report(Code::PAL0201, most + 3, 50'000);
  CHECK(many.diagnostics.errors() == most + 3);
  CHECK(many.diagnostics.not_kept().errors == 3);
  CHECK(many.diagnostics.not_kept().warnings == 7);
  CHECK(many.diagnostics.all().size() == 2 * most);
  // The check that reports one that is not kept may still add to it.
  many.diagnostics.report(Code::PAL0201, {many.file, 1, 2}, "late")
      .notes.push_back({{many.file, 0, 1}, "note"});
  CHECK(many.diagnostics.all().back().message == "finding");
  CHECK(many.text(100).ends_with("\u2026 and " + std::to_string(2 * most + 11 - 100) +
                                 " more; --max-errors 0 shows more; only the first 10000 errors and as many "
                                 "warnings are kept\n\n10004 errors, 10007 warnings\n"));
}
