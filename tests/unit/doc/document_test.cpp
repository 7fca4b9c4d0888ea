#include "pal/doc/document.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/unit/check/specification.hpp"

using namespace pal;

namespace {

doc::Document odd_texts() {
  MemoryFileSystem files;
  files.add("odd_texts.pal", test::source_file("tests/unit/doc/odd_texts.pal"));
  const auto checked = test::check_files(files, {"odd_texts.pal"});
  REQUIRE_FALSE(checked.diagnostics.has_errors());
  return doc::document(checked.specification.skills.at(0), checked.sources);
}

std::vector<std::string> all_of(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at)
    found.push_back((*at)[1]);
  return found;
}

}  // namespace

TEST_CASE(
    "a skill's document as Markdown: every slot, in the order of the thesis, nothing taken for markup") {
  const auto text = doc::markdown(odd_texts());
  const std::string golden = "tests/unit/doc/odd_texts.md";
  if (const char* rewrite = std::getenv("PAL_GOLDEN_REWRITE"); rewrite != nullptr && *rewrite == '1') {
    std::ofstream(std::string(PAL_SOURCE_DIR "/") + golden, std::ios::binary) << text;
  }
  CHECK(text == test::source_file(golden));
}

TEST_CASE("arrays and texts are told as what they are") {
  MemoryFileSystem files;
  files.add("survey.pal", test::source_file("tests/golden/codegen/survey.pal"));
  const auto checked = test::check_files(files, {"survey.pal"});
  REQUIRE_FALSE(checked.diagnostics.has_errors());
  const auto text = doc::markdown(doc::document(checked.specification.skills.at(0), checked.sources));
  CHECK(text.find("x, z: 255 x real, in mm; rank: 255 x integer; found: boolean; label: text") !=
        std::string::npos);
  CHECK(text.find(
            "| `location` | location | `\"park\"` | up to 100 characters | taught \"location\" to go to |") !=
        std::string::npos);
  CHECK(text.find("| `suffix` | text | `\"\"` |") != std::string::npos);
}

TEST_CASE("the order of figure 2.3") {
  const auto document = odd_texts();
  std::vector<std::string> titles;
  for (const auto& section : document.parts.at(0).sections) titles.push_back(section.title);
  titles.resize(13);
  CHECK(titles == std::vector<std::string>{"Generic Skill Name", "Textual Description", "Preconditions",
                                           "Postconditions", "Sensors", "Robotic Machines", "Model Data",
                                           "Logical Sensors", "Skill Methods", "Contingency Descriptions",
                                           "Contingency Methods", "Parameter List", "Completion Protocol"});
  CHECK(document.parts.at(1).title == "Logical Sensor Template: Listener");
}

TEST_CASE("the page is whole, well-formed and shows texts as they are written") {
  const auto page = doc::html({odd_texts(), odd_texts()});
  CHECK(page.find("&lt;script&gt;alert(&quot;x&quot;)&lt;/script&gt; &amp; nothing") != std::string::npos);
  CHECK(page.find("<script") == std::string::npos);
  CHECK(page.find("src=") == std::string::npos);  // nothing from elsewhere
  CHECK(page.find("<?xml") == std::string::npos);
  CHECK(all_of(page, "(<h1>)").size() == 2);
  CHECK(all_of(page, "(<svg role=\"img\" aria-label=)").size() == 6);

  const auto ids = all_of(page, " id=\"([^\"]*)\"");
  CHECK(std::set<std::string>(ids.begin(), ids.end()).size() == ids.size());

  std::vector<std::string> open;
  for (const auto& tag :
       all_of(page.substr(page.find("<html")), "<(/?[a-zA-Z0-9]+)(?: [^<>]*)?(?=[^/]>|>)")) {
    static const std::set<std::string> empty{"meta", "ellipse", "path", "polygon", "polyline", "br"};
    if (empty.count(tag) != 0) continue;
    if (tag.front() != '/') {
      open.push_back(tag);
    } else {
      REQUIRE_FALSE(open.empty());
      CHECK("/" + open.back() == tag);
      open.pop_back();
    }
  }
  CHECK(open.empty());
}
