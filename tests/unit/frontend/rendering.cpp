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
