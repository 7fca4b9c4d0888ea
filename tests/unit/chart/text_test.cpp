// Figures and widths of text.
#include <catch2/catch.hpp>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/labels.hpp"
#include "analyzer/chart/svg_writer.hpp"
#include "analyzer/chart/text_width.hpp"
#include "pal/support/xml.hpp"

namespace pal::analyzer::chart {
namespace {

TEST_CASE("durations are exact and have no trailing zeros") {
  CHECK(duration_text(0) == "0 ms");
  CHECK(duration_text(7) == "7 ns");
  CHECK(duration_text(5'200) == "5.2 \u00b5s");
  CHECK(duration_text(50'000) == "0.05 ms");
  CHECK(duration_text(7'350'000) == "7.35 ms");
  CHECK(duration_text(34'000'001) == "34.000001 ms");
  CHECK(duration_text(12'500'000'000) == "12.5 s");
  CHECK(duration_text(-1'000'000) == "\u22121 ms");
}

TEST_CASE("measured durations are rounded to the microsecond") {
  CHECK(rounded_duration_text(6'912'345) == "6.912 ms");
  CHECK(rounded_duration_text(6'912'500) == "6.913 ms");
  CHECK(rounded_duration_text(99'999) == "0.099999 ms");
}

TEST_CASE("text is cut so that it fits, between characters") {
  CHECK(text_width("", 100) == 0);
  CHECK(text_width("WTM", 100) == 247);
  CHECK(fitted("advance", 100, 1000) == "advance");
  const std::string cut = fitted("a very long statement", 100, 500);
  CHECK(cut.substr(cut.size() - 3) == "\u2026");
  CHECK(text_width(cut, 100) <= 500);
  CHECK(fitted("advance", 100, 50).empty());
  const std::string umlauts = fitted("üüüüüüüüüüüü", 100, 700);
  CHECK(umlauts.size() % 2 == 1);  // whole two-byte characters and the three bytes of the ellipsis
}

TEST_CASE("bold text that is cut fits, too") {
  for (const char* name :
       {"main-application-core-of-the-controller", "WWWWWWWWWWWWWWWW", "iiiiiiiiiiiiiiiiiiiiiiii"}) {
    for (const Length width : {300, 900, 1300})
      CHECK(text_width(fitted(name, 90, width, true), 90, true) <= width);
  }
  CHECK(text_width(fitted("main-application-core", 90, 900), 90, true) > 900);  // as plain text it would not
}

TEST_CASE("a place is given once") {
  Labels labels;
  CHECK(labels.claim({0, 0, 10, 10}));
  CHECK_FALSE(labels.claim({5, 5, 15, 15}));
  CHECK(labels.claim({10, 0, 20, 10}));
}

TEST_CASE("what XML does not allow is replaced") {
  CHECK(xml_escaped("a<b>&\"c\"") == "a&lt;b&gt;&amp;&quot;c&quot;");
  CHECK(xml_escaped(std::string(1, '\x01')) == "\uFFFD");
  CHECK(xml_escaped("a\uFFFEb\uFFFFc\uFFFD\U0001F916") == "a\uFFFDb\uFFFDc\uFFFD\U0001F916");
  CHECK(xml_escaped("a\xFF\xC3z") == "a\uFFFD\uFFFDz");
  CHECK(xml_escaped("\xED\xA0\x80") == "\uFFFD\uFFFD\uFFFD");  // half of a surrogate pair
}

}  // namespace
}  // namespace pal::analyzer::chart
