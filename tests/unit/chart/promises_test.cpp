// Promises of the environment that a run broke, as the chart shows them.
#include <algorithm>
#include <catch2/catch.hpp>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/html.hpp"
#include "tests/unit/chart/signs_trace.hpp"
#include "tests/unit/chart/svg_reader.hpp"

namespace pal::analyzer::chart {
namespace {

const char* const of_device = "tick from alter comes every 28 ms";
const char* const of_statement = "interpret takes 1 ms at most";

/// A measured run in which a device breaks a promise twice, and a thread another one once.
trace::Trace broken_run() {
  trace::Trace run = signs_trace();
  run.origin = "measured";
  run.promises = {of_device, of_statement};
  const auto add = [&run](std::int64_t at_ns, std::int32_t actor, std::int32_t promise) {
    const auto after = std::find_if(run.events.begin(), run.events.end(),
                                    [&](const trace::Event& event) { return event.time_ns > at_ns; });
    run.events.insert(after, {at_ns, trace::Kind::broken, actor, -1, -1, promise});
  };
  add(1'500'000, 3, 0);
  add(5'500'000, 3, 0);
  add(6'000'000, 1, 1);
  return run;
}

std::size_t count(const SvgContent& content, const std::string& style, const std::string& title) {
  return static_cast<std::size_t>(
      std::count_if(content.elements.begin(), content.elements.end(), [&](const SvgElement& element) {
        return element.style == style && element.title.find(title) != std::string::npos;
      }));
}

bool says(const SvgContent& content, const std::string& words) {
  return std::any_of(content.texts.begin(), content.texts.end(),
                     [&](const SvgText& text) { return text.content == words; });
}

}  // namespace

TEST_CASE("each broken promise has a sign, an entry in the list and one in the key") {
  const SvgContent content = read_svg(svg(timeline(broken_run()), ChartOptions()));
  REQUIRE(content.problem.empty());
  CHECK(count(content, "broken", std::string("alter: promise broken: ") + of_device) == 2);
  CHECK(count(content, "broken", std::string("LS1: promise broken: ") + of_statement) == 1);
  CHECK(says(content, of_device));
  CHECK(says(content, of_statement));
  CHECK(says(content, "first at 1.5 ms, 2 times"));
  CHECK(says(content, "at 6 ms"));
  CHECK(says(content, "promise broken"));
}

TEST_CASE("a run that keeps its promises has neither sign nor list") {
  const SvgContent content = read_svg(svg(timeline(signs_trace()), ChartOptions()));
  CHECK(count(content, "broken", "") == 0);
  CHECK_FALSE(says(content, "promise broken"));
  CHECK_FALSE(says(content, "Broken promises of the environment"));
}

TEST_CASE("a timeline lists what is broken, and so does the page to move in") {
  const Timeline run = timeline(broken_run());
  CHECK(dump(run).find(std::string("1500000 broken promise at alter: ") + of_device) != std::string::npos);
  Book book;
  book.runs = {run};
  CHECK(html(book).find("\"broken\",") != std::string::npos);
}

}  // namespace pal::analyzer::chart
