// Every finding has a page, and what the pages show is true of the program.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "pal/explain/codes.hpp"
#include "pal/explain/page.hpp"
#include "pal/explain/reference.hpp"
#include "tests/unit/driver/program.hpp"

using namespace pal;

namespace {

/// What no PAL text can show, and why.
const std::set<Code> not_shown{
    Code::PAL0112,  // bytes that are no UTF-8 cannot stand in a page
};

/// Codes from before there were pages; only ever shorter.
const std::set<std::string_view> waiting_for_a_page{
    "PAL0101", "PAL0102", "PAL0103", "PAL0104", "PAL0105", "PAL0106", "PAL0107", "PAL0108", "PAL0109",
    "PAL0110", "PAL0111", "PAL0113", "PAL0201", "PAL0202", "PAL0203", "PAL0204", "PAL0206", "PAL0207",
    "PAL0208", "PAL0209", "PAL0210", "PAL0211", "PAL0212", "PAL0213", "PAL0214", "PAL0215", "PAL0301",
    "PAL0302", "PAL0303", "PAL0304", "PAL0305", "PAL0306", "PAL0402", "PAL0403", "PAL0404", "PAL0405",
    "PAL0406", "PAL0501", "PAL0502", "PAL0504", "PAL0505", "PAL0506", "PAL0507", "PAL0508", "PAL0521",
    "PAL0522", "PAL0523", "PAL0524", "PAL0525", "PAL0526", "PAL0601", "PAL0602", "PAL0603", "PAL0604",
    "PAL0605", "PAL0606", "PAL0607", "PAL0608", "PAL0609", "PAL0610", "PAL0611", "PAL0612", "PAL0701",
    "PAL0702", "PAL0703", "PAL0704", "PAL0705", "PAL0706", "PAL0707", "PAL0708", "PAL0709", "PAL0710",
    "PAL0711", "PAL0712", "PAL0713", "PAL0714", "PAL0721", "PAL0722", "PAL0723", "PAL0724", "PAL0725",
    "PAL0726", "PAL0727", "PAL0728", "PAL0729", "PAL0730", "PAL0801", "PAL0802", "PAL0803", "PAL0811",
    "PAL0812", "PAL0813", "PAL0814", "PAL0890", "PAL0891", "PAL0901", "PAL0902"};

struct Found {
  std::set<std::string> codes;
  std::size_t errors = 0;
  std::string text;
};

/// What `pal check` says of a sample, with everything that it would do.
Found check(const Sample& sample) {
  MemoryFileSystem files;
  for (const SampleFile& file : sample.files) files.add(file.name, file.text);
  std::vector<std::string> arguments{"check", sample.files.front().name};
  arguments.insert(arguments.end(), sample.options.begin(), sample.options.end());
  Found found;
  found.text = test::pal(arguments, files).err;
  arguments.insert(arguments.end(), {"--format", "json"});
  const auto document = nlohmann::json::parse(test::pal(arguments, files).out);
  for (const auto& finding : document.at("diagnostics")) {
    found.codes.insert(finding.at("code"));
    if (finding.at("severity") == "error") ++found.errors;
  }
  return found;
}

}  // namespace

TEST_CASE("every finding has a page with what it means, an example and a cure") {
  for (const Code code : all_codes()) {
    if (waiting_for_a_page.contains(name(code))) continue;
    CAPTURE(name(code), title(code));
    const Page page = explain(code);
    CHECK_FALSE(page.summary.empty());
    CHECK(page.markdown.ends_with("\n"));
    CHECK(page.markdown.find("\n### Example\n") != std::string_view::npos);
    CHECK(page.markdown.find("\n### Cure\n") != std::string_view::npos);
    CHECK(page.example.files.empty() == not_shown.contains(code));
    CHECK(page.cure.files.empty() == not_shown.contains(code));
  }
}

TEST_CASE("every example gives its finding, and every cure removes it and has no errors") {
  for (const Code code : all_codes()) {
    const Page page = explain(code);
    if (page.example.files.empty() || page.cure.files.empty()) continue;
    const std::string expected(name(code));
    CAPTURE(expected);
    const Found wrong = check(page.example);
    {
      INFO(wrong.text);
      CHECK(wrong.codes.contains(expected));
      // A page is about one thing: what else goes wrong in its example is of no other family of errors.
      CHECK(wrong.errors <= 3);
    }
    const Found right = check(page.cure);
    INFO(right.text);
    CHECK_FALSE(right.codes.contains(expected));
    CHECK(right.errors == 0);
  }
}

TEST_CASE("docs/diagnostics.md is what pal explain --all prints") {
  std::ostringstream now;
  write_reference(now);
  const auto committed = DiskFileSystem().read(PAL_SOURCE_DIR "/docs/diagnostics.md");
  REQUIRE(std::holds_alternative<std::string>(committed));
  // Not CHECK( == ): the difference of two documents is no use to anybody.
  const bool same = std::get<std::string>(committed) == now.str();
  INFO("write it again: pal explain --all > docs/diagnostics.md");
  CHECK(same);
}
