// Charts as pictures: well formed, everything in the page, labels apart, the same bytes.
#include <catch2/catch.hpp>
#include <fstream>
#include <locale>
#include <random>

#include "analyzer/chart/chart.hpp"
#include "tests/unit/chart/example.hpp"
#include "tests/unit/chart/svg_reader.hpp"

namespace pal::analyzer::chart {
namespace {

/// For a person to look at: build/<preset>/tests/unit/chart/*.svg.
void save(const std::string& name, const std::string& text) {
  std::ofstream(std::string(PAL_BINARY_DIR) + "/" + name, std::ios::binary) << text;
}

bool overlap(const Box& a, const Box& b) {
  return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

/// Empty if the picture is as it should be, else what is wrong.
std::string fault_of(const std::string& picture) {
  const SvgContent content = read_svg(picture);
  if (!content.problem.empty()) return content.problem;
  for (const SvgText& text : content.texts) {
    const Box& box = text.box;
    if (box.x0 < 0 || box.y0 < 0 || box.x1 > content.width || box.y1 > content.height) {
      return "\"" + text.content + "\" is not in the page";
    }
  }
  for (std::size_t i = 0; i < content.texts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(content.texts[i].box, content.texts[j].box)) {
        const Box& at = content.texts[i].box;
        return "\"" + content.texts[i].content + "\" is over \"" + content.texts[j].content + "\" at " +
               std::to_string(at.x0) + ", " + std::to_string(at.y0);
      }
    }
  }
  return {};
}

TEST_CASE("the corrected touch holds") {
  const Example example = worst_touch({});
  const std::string picture = svg(example.timeline, example.options);
  save("touch.svg", picture);
  CHECK(fault_of(picture) == "");
  CHECK_THAT(picture, Catch::Contains(">touch in workcell: fresh-force holds<"));
  CHECK_THAT(picture, Catch::Contains(">age of pc-force 7.3 ms<"));
  CHECK_THAT(picture, Catch::Contains(
                          "worst case 7.3 ms (exact: the run below attains it), limit 10 ms, margin 2.7 ms"));
  CHECK_THAT(picture, Catch::Contains("band holds"));
}

TEST_CASE("the touch that reads first fails, and the chart says why") {
  const Example example = worst_touch({true});
  const std::string picture = svg(example.timeline, example.options);
  save("touch_read_first.svg", picture);
  CHECK(fault_of(picture) == "");
  CHECK_THAT(picture, Catch::Contains("band fails"));
  CHECK_THAT(picture, Catch::Contains(">age of pc-force 34.75 ms<"));
  CHECK_THAT(picture, Catch::Contains("24.75 ms too much"));
  CHECK_THAT(picture, Catch::Contains(">How the 34.75 ms come about<"));
}

TEST_CASE("actions that take no time are still there, with their numbers") {
  const Example example = worst_touch({true, true});
  const std::string picture = svg(example.timeline, example.options);
  save("touch_read_first_no_costs.svg", picture);
  CHECK(fault_of(picture) == "");
  CHECK_THAT(picture, Catch::Contains(">age of pc-force 34 ms<"));
}

TEST_CASE("a measured run is laid over the proved one") {
  const Example proved = worst_touch({});
  TouchRun run;
  run.percent = 90;
  const Example measured = worst_touch(run);
  const std::string picture =
      overlay_svg(proved.timeline, measured.timeline, {proved.options, measured.options, {}, {}});
  save("touch_overlay.svg", picture);
  CHECK(fault_of(picture) == "");
  CHECK_THAT(picture, Catch::Contains(">proved at most 7.3 ms, measured 6.69 ms, limit 10 ms<"));
  CHECK_THAT(picture, Catch::Contains(">proved: age of pc-force 7.3 ms<"));
  CHECK_THAT(picture, Catch::Contains(">measured: age of pc-force 6.69 ms<"));
}

TEST_CASE("a run without anything to point out is drawn as it is") {
  TouchRun run;
  run.end_ns = 20'000'000;
  const Timeline whole = timeline(touch_trace(run));
  const std::string picture = svg(whole, {});
  save("touch_whole.svg", picture);
  CHECK(fault_of(picture) == "");
}

TEST_CASE("an empty run is a chart with nothing in it") {
  trace::Trace trace;
  trace.skill = "nothing";
  CHECK(fault_of(svg(timeline(trace), {})) == "");
}

TEST_CASE("every action, wait and message of a panel has a title with its times") {
  const Example example = worst_touch({});
  const std::string picture = svg(example.timeline, example.options);
  // The key's samples come after the panels and have their text beside them.
  for (const SvgElement& element : read_svg(picture.substr(0, picture.find(">Key<"))).elements) {
    const bool timed = element.style.rfind("bar ", 0) == 0 || element.style.rfind("wait", 0) == 0 ||
                       element.style.rfind("arrow", 0) == 0 || element.style.rfind("set", 0) == 0;
    if (timed) CHECK_THAT(element.title, Catch::Contains(" ms"));
  }
}

TEST_CASE("names with the characters of XML are text") {
  trace::Trace trace;
  trace.skill = "a<b & \"c\"";
  trace.actors = {{"<SM1>", false, "P&0", 1}};
  trace.statements = {{"SM1", "a&b", "x<y>.pal", 1}};
  trace.events = {{0, trace::Kind::start, 0, 0, -1, 0}, {1'000'000, trace::Kind::done, 0, 0, -1, 0}};
  const std::string picture = svg(timeline(trace), {});
  CHECK(fault_of(picture) == "");
  CHECK_THAT(picture, Catch::Contains("&lt;SM1&gt;") && Catch::Contains("a&lt;b &amp; &quot;c&quot;"));
}

TEST_CASE("labels never overlap and stay in the page") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto number = [&](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  for (int i = 0; i < 60; ++i) {
    TouchRun run;
    run.read_first = number(0, 1) == 1;
    run.no_costs = number(0, 3) == 0;
    run.tick_ns = number(0, 28'000'000);
    run.percent = static_cast<int>(number(30, 100));
    Example example = example_of(touch_trace(run));
    const std::int64_t from = number(0, 50'000'000);
    if (number(0, 2) == 0) example.options.window = Window{from, from + number(1, 60'000'000)};
    if (number(0, 3) == 0) example.options.highlight.reset();
    example.options.narrow = number(0, 2) == 0;
    if (number(0, 2) == 0)
      example.options.highlight = Highlight{from, from + number(0, 9'000'000), "response",
                                            true, number(0, 9'000'000),        number(0, 1) == 1};
    CAPTURE(i, run.read_first, run.no_costs, run.tick_ns, run.percent, from);
    REQUIRE(fault_of(svg(example.timeline, example.options)) == "");
    Example other = worst_touch({});
    other.options.narrow = example.options.narrow;
    REQUIRE(fault_of(overlay_svg(other.timeline, example.timeline,
                                 {other.options, example.options, {}, {}})) == "");
  }
}

TEST_CASE("no locale changes a byte") {
  struct Grouped : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const Example example = worst_touch({true});
  const std::string before = svg(example.timeline, example.options);
  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new Grouped));
  const std::string after = svg(example.timeline, example.options);
  std::locale::global(old);
  CHECK(before == after);
}

}  // namespace
}  // namespace pal::analyzer::chart
