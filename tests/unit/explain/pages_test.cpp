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
#include "tests/unit/program/program.hpp"

using namespace pal;

namespace {

/// What no PAL text can show, and why.
const std::set<Code> not_shown{
    Code::PAL0112,  // bytes that are no UTF-8 cannot stand in a page
    Code::PAL0525,  // a skill as large as that fills many pages
    Code::PAL0730,  // so does this one
    Code::PAL1018,  // a storyboard finds it, no check
};

struct Found {
  std::set<std::string> codes;
  std::size_t errors = 0;
  std::string text;
};

/// What `pal check` says of a sample, with everything that it would do.
Found checked(const explain::Sample& sample) {
  MemoryFileSystem files;
  for (const explain::SampleFile& file : sample.files) files.add(file.name, file.text);
  std::vector<std::string> arguments{"check", sample.files.front().name};
  if (arguments.back().ends_with(".op.json")) arguments.insert(arguments.begin(), "operation");
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
  for (const Code code : explain::all_codes()) {
    CAPTURE(name(code), title(code));
    const explain::Page page = explain::explain(code);
    CHECK_FALSE(page.summary.empty());
    CHECK(page.markdown.ends_with("\n"));
    CHECK(page.markdown.find("\n### Example\n") != std::string_view::npos);
    CHECK(page.markdown.find("\n### Cure\n") != std::string_view::npos);
    CHECK(page.example.files.empty() == not_shown.contains(code));
    CHECK(page.cure.files.empty() == not_shown.contains(code));
  }
}

TEST_CASE("every example gives its finding, and every cure removes it and has no errors") {
  for (const Code code : explain::all_codes()) {
    const explain::Page page = explain::explain(code);
    if (page.example.files.empty() || page.cure.files.empty()) continue;
    const std::string expected(name(code));
    CAPTURE(expected);
    const Found wrong = checked(page.example);
    {
      INFO(wrong.text);
      CHECK(wrong.codes.contains(expected));
      // A page is about one thing: what else goes wrong in its example is of no other family of errors.
      CHECK(wrong.errors <= (code == Code::PAL0104 ? 21 : 3));
    }
    const Found right = checked(page.cure);
    INFO(right.text);
    CHECK_FALSE(right.codes.contains(expected));
    CHECK(right.errors == 0);
  }
}

TEST_CASE("docs/reference/diagnostics.md is what pal explain --all prints") {
  std::ostringstream now;
  explain::write_reference(now);
  const auto committed = DiskFileSystem().read(PAL_SOURCE_DIR "/docs/reference/diagnostics.md");
  REQUIRE(std::holds_alternative<std::string>(committed));
  // Not CHECK( == ): the difference of two documents is of no use.
  const bool same = std::get<std::string>(committed) == now.str();
  INFO("write it again: pal explain --all > docs/reference/diagnostics.md");
  CHECK(same);
}
