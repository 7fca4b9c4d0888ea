// The page to move in: what it is made of, without a browser.
#include "analyzer/chart/html.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/unit/chart/example.hpp"

namespace pal::analyzer::chart {
namespace {

using Json = nlohmann::json;

Book book_of(const Example& example) {
  Book book;
  book.title = "touch";
  book.runs = {example.timeline};
  View view{"worst run", 0, example.options.highlight, {}, {}, {}};
  for (const Segment& segment : example.options.explanation) view.why.push_back({segment, {}});
  book.subjects = {{"touch", "workcell", example.options.caption, "7.3 ms of 10 ms", {view}}};
  return book;
}

Json data_of(const std::string& page) {
  const std::string begin = "<script type=\"application/json\" id=\"runs\">";
  const std::size_t at = page.find(begin) + begin.size();
  return Json::parse(page.substr(at, page.find("</script>", at) - at));
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TEST_CASE("the page needs no address and no file, and its own rules forbid them") {
  const std::string page = html(book_of(worst_touch({})));
  std::ofstream(std::string(PAL_BINARY_DIR) + "/touch.html", std::ios::binary) << page;
  for (const char* outside : {"http:", "https:", " src=", " href=", "url(", "@import", "fetch(", "XMLHttp"}) {
    CAPTURE(outside);
    CHECK(page.find(outside) == std::string::npos);
  }
  CHECK_THAT(page, Catch::Contains("default-src 'none'"));
  CHECK(page.rfind("<!DOCTYPE html>", 0) == 0);
  CHECK(count(page, "<script") == 2);
  CHECK(count(page, "</script>") == 2);
  for (const char* place : {"@TITLE@", "@STYLE@", "@DATA@", "@SCRIPT@"})
    CHECK(page.find(place) == std::string::npos);
}

TEST_CASE("a page holds no U+FFFE and no U+FFFF, and its data has them all the same") {
  Book book = book_of(worst_touch({}));
  book.title = "n\xEF\xBF\xBF";
  book.subjects.front().skill = "n\xEF\xBF\xBE<\xEF\xBF\xBF";
  const std::string page = html(book);
  CHECK(page.find("\xEF\xBF\xBE") == std::string::npos);
  CHECK(page.find("\xEF\xBF\xBF") == std::string::npos);
  CHECK(data_of(page).at("requirements").front().at("skill") == book.subjects.front().skill);
}

TEST_CASE("every element that the script asks for is in the page, once") {
  const std::string page = html(book_of(worst_touch({})));
  std::set<std::string> names;
  for (const std::string begin : {"get(\"", "getElementById(\""}) {
    for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
      const std::size_t from = at + begin.size();
      names.insert(page.substr(from, page.find('"', from) - from));
    }
  }
  CHECK(names.size() > 10);
  for (const std::string& name : names) {
    CAPTURE(name);
    CHECK(count(page, " id=\"" + name + "\"") == 1);
  }
}

TEST_CASE("the page holds every bar, wait, message and condition of the run, and the interval") {
  const Example example = worst_touch({true});
  const Json data = data_of(html(book_of(example)));
  const Json& run = data["runs"][0];
  REQUIRE(run["lanes"].size() == example.timeline.lanes.size());
  for (std::size_t i = 0; i < example.timeline.lanes.size(); ++i) {
    const Lane& lane = example.timeline.lanes[i];
    CHECK(run["lanes"][i]["name"] == lane.name);
    REQUIRE(run["lanes"][i]["bars"].size() == lane.bars.size());
    CHECK(run["lanes"][i]["gaps"].size() == lane.gaps.size());
    for (std::size_t b = 0; b < lane.bars.size(); ++b) {
      const Json& bar = run["lanes"][i]["bars"][b];
      CHECK(bar[0] == lane.bars[b].from_ns);
      CHECK(bar[1] == lane.bars[b].to_ns);
      CHECK(run["texts"][bar[3].get<std::size_t>()]["text"] == lane.bars[b].text);
    }
  }
  CHECK(run["arrows"].size() == example.timeline.arrows.size());
  CHECK(run["waves"].size() == example.timeline.waveforms.size());
  CHECK(run["marks"].size() == example.timeline.marks.size());
  const Json& requirement = data["requirements"][0];
  CHECK(requirement["name"] == "fresh-force");
  CHECK(requirement["verdict"] == "fails");
  CHECK(requirement["views"][0]["highlight"]["from"] == example.options.highlight->from_ns);
  CHECK(requirement["views"][0]["why"].size() == example.options.explanation.size());
}

TEST_CASE("what is inside a part, and what is lost, is in the page") {
  Book book = book_of(worst_touch({}));
  book.subjects[0].views[0].why = {{{0, 10, "waits", "SM1", "", 0}, {{{0, 10, "works", "LS1", "", 0}, {}}}}};
  book.subjects[0].views[0].losses = {{"force-torque", 5, 9, "lost"}};
  const Json view = data_of(html(book))["requirements"][0]["views"][0];
  CHECK(view["why"][0]["inside"][0]["actor"] == "LS1");
  CHECK(view["losses"][0]["lane"] == "force-torque");
}

TEST_CASE("no name ends the script or the title") {
  Book book = book_of(worst_touch({}));
  book.title = "</title><b>";
  book.runs[0].lanes[0].name = "</script><script>alert(1)</script>";
  const std::string page = html(book);
  CHECK(count(page, "</script>") == 2);
  CHECK_THAT(page, Catch::Contains("&lt;/title&gt;"));
  CHECK(data_of(page)["runs"][0]["lanes"][0]["name"] == book.runs[0].lanes[0].name);
}

TEST_CASE("the same book gives the same page") {
  CHECK(html(book_of(worst_touch({}))) == html(book_of(worst_touch({}))));
}

}  // namespace
}  // namespace pal::analyzer::chart
