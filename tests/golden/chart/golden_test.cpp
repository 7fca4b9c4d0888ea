// Charts against files that a person has looked at. PAL_GOLDEN_REWRITE=1 in the environment writes them
// again.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "analyzer/chart/chart.hpp"
#include "tests/unit/chart/example.hpp"
#include "tests/unit/chart/signs_trace.hpp"

namespace pal::analyzer::chart {
namespace {

void expect_golden(const std::string& name, const std::string& text) {
  const std::string path = std::string(PAL_GOLDEN_DIR) + "/" + name;
  if (const char* rewrite = std::getenv("PAL_GOLDEN_REWRITE"); rewrite != nullptr && *rewrite == '1') {
    std::ofstream(path, std::ios::binary) << text;
    SUCCEED(path + " is written anew");
    return;
  }
  std::ifstream in(path, std::ios::binary);
  std::ostringstream golden;
  golden << in.rdbuf();
  INFO(path);
  CHECK(golden.str() == text);
}

TEST_CASE("one of everything, as data and as a picture") {
  const Timeline signs = timeline(signs_trace());
  expect_golden("signs.txt", dump(signs));
  ChartOptions options;
  options.caption = {"answer-alter",
                     "response from tick of alter to TXM( correction to alter )",
                     "fails",
                     "no bound is known, limit 6 ms",
                     "",
                     "6 ms"};
  options.highlight = Highlight{1'500'000, 9'500'000, "response to tick", true, 6'000'000};
  options.deadlines = {{8'500'000, "next tick"}};
  expect_golden("signs.svg", svg(signs, options));
}

TEST_CASE("the touch skill, as data") {
  const Example good = worst_touch({});
  const Highlight& highlight = *good.options.highlight;
  expect_golden("touch.txt", dump(good.timeline, highlight.from_ns, highlight.to_ns));
}

TEST_CASE("the touch skill that reads first, as a picture") {
  const Example bad = worst_touch({true});
  expect_golden("touch_read_first.svg", svg(bad.timeline, bad.options));
}

}  // namespace
}  // namespace pal::analyzer::chart
