#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "pal/support/finding.hpp"
#include "pal/support/render.hpp"

using namespace pal;

TEST_CASE("findings are sorted by place, and repeats told once") {
  SourceManager sources;
  const auto file = sources.add("a.pal", "one\ntwo\n");
  Diagnostics diagnostics;
  diagnostics.report(Finding::unknown_module, {file, 4, 7}, "two");
  diagnostics.report(Finding::unknown_module, {file, 0, 3}, "one");
  diagnostics.report(Finding::unknown_module, {file, 4, 7}, "two");
  diagnostics.report(Finding::module_not_used, {});
  const auto sorted = diagnostics.sorted();
  REQUIRE(sorted.size() == 3);
  CHECK(sorted[0].finding == Finding::module_not_used);
  CHECK(sorted[1].message == "there is no module 'one'");
  CHECK(sorted[2].message == "there is no module 'two'");
  CHECK(diagnostics.errors() == 3);
}

TEST_CASE("the JSON form has every part of a finding") {
  SourceManager sources;
  const auto file = sources.add("a.pal", "one\ntwo\n");
  Diagnostics diagnostics;
  auto& finding = diagnostics.report(Finding::unknown_message, {file, 4, 7}, "two");
  finding.note({file, 0, 3}, Remark::declared_here);
  const auto json = nlohmann::json::parse(render_json(diagnostics.sorted(), sources));
  REQUIRE(json.size() == 1);
  CHECK(json[0]["code"] == "PAL0202");
  CHECK(json[0]["severity"] == "error");
  CHECK(json[0]["file"] == "a.pal");
  CHECK(json[0]["line"] == 2);
  CHECK(json[0]["column"] == 1);
  CHECK(json[0]["end_column"] == 4);
  CHECK(json[0]["message"] == "there is no message 'two'");
  CHECK(json[0]["hint"] == "declare it: MESSAGE two : with its type, such as REAL N");
  CHECK(json[0]["hint_for"] == "all");
  CHECK(json[0]["finding"] == "unknown_message");
  CHECK(json[0]["arguments"] == nlohmann::json{{"message", "two"}});
  CHECK(json[0]["notes"][0]["line"] == 1);
  CHECK(render_json({}, sources) == "[]");
}

TEST_CASE("of a very long line only the part around the place is shown") {
  SourceManager sources;
  const auto file = sources.add("a.pal", std::string(1'000'000, 'x') + "HERE" + std::string(1'000'000, 'y'));
  Diagnostics diagnostics;
  diagnostics.report(Finding::unexpected, {file, 1'000'000, 1'000'004}, "this");
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

  void report(FindingWith<0> finding, std::size_t count, std::uint32_t begin) {
    for (std::size_t i = 0; i < count; ++i, ++begin) diagnostics.report(finding, {file, begin, begin + 1});
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
  many.report(Finding::module_not_used, 6, 0);
  many.report(Finding::graph_names_no_module, 5, 100);
  const auto seven = many.text(7);
  CHECK(occurrences(seven, "error[PAL0115]") == 5);
  CHECK(occurrences(seven, "warning[PAL0209]") == 2);
  CHECK(seven.ends_with("\n\n\u2026 and 4 more; --max-errors 0 shows all\n\n5 errors, 6 warnings\n"));
  CHECK(seven.find("warning[") < seven.find("error["));  // in the order of the text
  const auto three = many.text(3);
  CHECK(occurrences(three, "error[") == 3);
  CHECK(occurrences(three, "warning[") == 0);
  CHECK(three.ends_with("\u2026 and 8 more; --max-errors 0 shows all\n\n5 errors, 6 warnings\n"));
  for (const std::size_t all : {0, 11, 12}) {
    CHECK(occurrences(many.text(all), "[PAL0") == 11);
    CHECK(many.text(all).find("more") == std::string::npos);
  }
}

TEST_CASE("findings beyond the limit of their severity are counted and not kept") {
  constexpr auto most = Diagnostics::most_kept;
  Many many;
  many.report(Finding::module_not_used, most + 7, 0);
  CHECK_FALSE(many.diagnostics.has_errors());
  many.report(Finding::graph_names_no_module, most + 3, 50'000);
  CHECK(many.diagnostics.errors() == most + 3);
  CHECK(many.diagnostics.not_kept().errors == 3);
  CHECK(many.diagnostics.not_kept().warnings == 7);
  CHECK(many.diagnostics.all().size() == 2 * most);
  // The check that reports one that is not kept may still add to it.
  many.diagnostics.report(Finding::unexpected, {many.file, 1, 2}, "late")
      .note({many.file, 0, 1}, Remark::declared_here);
  CHECK(many.diagnostics.all().back().finding == Finding::graph_names_no_module);
  CHECK(many.text(100).ends_with("\u2026 and " + std::to_string(2 * most + 11 - 100) +
                                 " more; --max-errors 0 shows more; only the first 10000 errors and as many "
                                 "warnings are kept\n\n10004 errors, 10007 warnings\n"));
}
