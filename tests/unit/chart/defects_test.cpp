// What has once been wrong with charts, a case each.
#include <algorithm>
#include <catch2/catch.hpp>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/detail.hpp"
#include "analyzer/chart/time_scale.hpp"
#include "tests/unit/chart/example.hpp"
#include "tests/unit/chart/svg_reader.hpp"

namespace pal::analyzer::chart {
namespace {

constexpr std::int64_t us = 1'000;
constexpr std::int64_t ms = 1'000'000;

Bar bar(std::int64_t from, std::int64_t to, const std::string& text, BarKind kind = BarKind::message) {
  return {from, to, kind, text, "M", "m.pal", 1, false, true};
}

/// One thread that acts shortly at 0, works long, and acts shortly again.
Timeline long_work() {
  Timeline run;
  run.skill = "work";
  run.origin = "predicted";
  run.end_ns = 40 * ms;
  run.lanes = {{"SM1", false, "P0", 1, {}, {}}};
  run.lanes[0].bars = {bar(0, 50 * us, "WTM( a from A )"), bar(50 * us, 100 * us, "TXM( b to B )"),
                       bar(100 * us, 30 * ms, "work-very-long", BarKind::computation),
                       bar(30 * ms, 30 * ms + 50 * us, "TXM( c to C )"),
                       bar(30 * ms + 50 * us, 30 * ms + 100 * us, "TXM( d to D )")};
  return run;
}

ChartOptions over(std::int64_t from, std::int64_t to, std::int64_t limit) {
  ChartOptions options;
  options.highlight = Highlight{from, to, "response", false, limit};
  return options;
}

std::size_t length_of(const std::vector<Window>& windows) {
  std::int64_t sum = 0;
  for (const Window& window : windows) sum += window.to_ns - window.from_ns;
  return static_cast<std::size_t>(sum);
}

const SvgText* text_with(const SvgContent& content, const std::string& words) {
  const auto found = std::find_if(content.texts.begin(), content.texts.end(), [&](const SvgText& text) {
    return text.content.find(words) != std::string::npos;
  });
  return found == content.texts.end() ? nullptr : &*found;
}

/// Two threads that send to each other every 20 us for so long.
Timeline chatter(std::int64_t end) {
  Timeline run;
  run.skill = "chatter";
  run.origin = "predicted";
  run.end_ns = end;
  run.lanes = {{"SM1", false, "P0", 1, {}, {}}, {"LS1", false, "P1", 1, {}, {}}};
  for (std::int64_t at = 0; at < end; at += 20 * us) {
    run.lanes[0].bars.push_back(bar(at, at + 2 * us, "TXM( a to LS1 )"));
    run.lanes[1].bars.push_back(bar(at + 4 * us, at + 6 * us, "WTM( a from SM1 )"));
    run.arrows.push_back({0, at + 2 * us, 1, at + 4 * us, at + 4 * us, "a", Fate::taken});
  }
  return run;
}

TEST_CASE("what is too much to see is drawn as blocks, and the picture stays small") {
  const std::string large = svg(chatter(200 * ms), over(0, 200 * ms - 14 * us, 150 * ms));
  CHECK(large.size() < 200'000);
  CHECK(large.find("class=\"crowd\"") != std::string::npos);
  CHECK(large.find("many actions, without their messages") != std::string::npos);
  // The first and the last action are those of the interval: each by itself.
  CHECK(large.find("SM1: TXM( a to LS1 )") != std::string::npos);
  CHECK(large.find("LS1: WTM( a from SM1 )") != std::string::npos);

  const std::string small = svg(chatter(1 * ms), over(0, 1 * ms - 14 * us, 150 * ms));
  CHECK(small.find("crowd") == std::string::npos);
  ChartOptions options = over(0, 200 * ms - 14 * us, 150 * ms);
  options.ids = true;
  CHECK(svg(chatter(200 * ms), options).find("crowd") == std::string::npos);
}

TEST_CASE("of a long action only its ends are enlarged") {
  const Timeline run = long_work();
  const ChartOptions options = over(0, 30 * ms + 100 * us, -1);
  const Layer layer{&run, &options, Role::only, 0, {0}, {}};
  const auto windows = detail_windows({layer}, overview_window({layer}), 8'000, 300);
  REQUIRE(windows.size() == 2);
  CHECK(length_of(windows) < 1 * ms);
  CHECK(windows[1].from_ns <= 30 * ms);
  CHECK(windows[1].to_ns >= 30 * ms + 100 * us);
}

TEST_CASE("an end of a long action that lies outside of the picture is not enlarged") {
  const Timeline run = long_work();
  const ChartOptions options = over(5 * ms, 30 * ms, -1);
  const Layer layer{&run, &options, Role::only, 0, {0}, {}};
  const Window whole = overview_window({layer});
  REQUIRE(whole.from_ns > 200 * us);
  for (const Window& part : detail_windows({layer}, whole, 8'000, 300)) {
    CHECK(part.from_ns >= whole.from_ns);
    CHECK(part.to_ns > part.from_ns);
  }
}

TEST_CASE("a crowded instant in the middle is enlarged before a long quiet stretch") {
  Timeline run = long_work();
  ChartOptions options = over(0, 39 * ms, -1);
  std::vector<Bar>& bars = run.lanes[0].bars;
  for (int i = 0; i < 6; ++i) {
    const std::int64_t at = 34 * ms + i * 50 * us;
    bars.push_back(bar(at, at + 50 * us, "SPC( c )", BarKind::condition));
    options.explanation.push_back({at, at + 50 * us, "runs SPC( c )", "SM1", "", 0});
  }
  bars.push_back(bar(39 * ms - 50 * us, 39 * ms, "TXM( e to E )"));
  const Layer layer{&run, &options, Role::only, 0, {0}, {}};
  const auto windows = detail_windows({layer}, overview_window({layer}), 8'000, 300);
  CHECK(std::any_of(windows.begin(), windows.end(), [](const Window& window) {
    return window.from_ns <= 34 * ms && window.to_ns >= 34 * ms + 300 * us;
  }));
}

TEST_CASE("every stretch has a labelled tick, however short it is") {
  const TimeScale scale({{0, 10 * ms}, {33'410 * us, 33'460 * us}, {50 * ms, 60 * ms}}, 0, 9'000, 300);
  const Ticks marks = ticks(scale, 0);
  for (const TimeScale::Piece& piece : scale.pieces()) {
    if (piece.folded) continue;
    const auto inside = std::find_if(marks.major.begin(), marks.major.end(), [&](const Tick& tick) {
      return tick.at_ns >= piece.time.from_ns && tick.at_ns <= piece.time.to_ns;
    });
    REQUIRE(inside != marks.major.end());
    CHECK_FALSE(inside->label.empty());
  }
  const auto middle = std::find_if(marks.major.begin(), marks.major.end(),
                                   [](const Tick& tick) { return tick.at_ns > 33 * ms; });
  CHECK(middle->label == "33.45");
}

TEST_CASE("what is left out stands across its fold, not under the axis") {
  const Example example = worst_touch({true});
  const std::string picture = svg(example.timeline, example.options);
  const SvgContent content = read_svg(picture);
  const SvgText* figure = text_with(content, " ms left out");
  REQUIRE(figure != nullptr);
  CHECK(figure->box.y1 - figure->box.y0 > figure->box.x1 - figure->box.x0);
}

TEST_CASE("a limit far beyond the interval is named at the edge") {
  const Timeline run = long_work();
  const ChartOptions near = over(0, 30 * ms, 32 * ms);
  const ChartOptions far = over(0, 30 * ms, 50 * ms);
  const Layer to_near{&run, &near, Role::only, 0, {0}, {}};
  const Layer to_far{&run, &far, Role::only, 0, {0}, {}};
  CHECK(overview_window({to_near}).to_ns >= 32 * ms);
  CHECK(overview_window({to_far}).to_ns <= 34 * ms);
  CHECK(text_with(read_svg(svg(run, far)), "limit 50 ms") != nullptr);
}

TEST_CASE("the key names what is drawn, not what the run has elsewhere") {
  Timeline run = long_work();
  run.lanes[0].gaps = {{35 * ms, 36 * ms, GapKind::ready, "work", false}};
  run.marks = {{38 * ms, MarkKind::overrun, 0, "lost"}};
  ChartOptions options;
  options.window = Window{0, 20 * ms};
  const SvgContent part = read_svg(svg(run, options));
  CHECK(text_with(part, "ready, but the processor is taken") == nullptr);
  CHECK(text_with(part, "event lost") == nullptr);
  const SvgContent whole = read_svg(svg(run, {}));
  CHECK(text_with(whole, "ready, but the processor is taken") != nullptr);
  CHECK(text_with(whole, "event lost") != nullptr);
}

TEST_CASE("a processor's long name is written whole") {
  Timeline run = long_work();
  run.lanes[0].processor = "vision-computer";
  const SvgContent content = read_svg(svg(run, {}));
  CHECK(text_with(content, "vision-computer") != nullptr);
}

TEST_CASE("explanations go on in the next line and are never cut") {
  Timeline run = long_work();
  ChartOptions options = over(0, 30 * ms, -1);
  std::string words;
  for (int i = 0; i < 40; ++i) words += "word" + std::to_string(i) + " ";
  for (int i = 0; i < 8; ++i)
    options.explanation.push_back({i * ms, (i + 1) * ms, words, "SM1", "m.pal:1", 0});
  const std::string picture = svg(run, options);
  const std::string below = picture.substr(picture.find("How the 30 ms come about"));
  CHECK(below.find("\u2026") == std::string::npos);
  const SvgContent content = read_svg(picture);
  CHECK(text_with(content, "(m.pal:1)") != nullptr);
  for (const SvgText& text : content.texts) CHECK(text.box.x1 <= content.width);
}

TEST_CASE("what is inside a part stands below it, indented and without a letter") {
  Timeline run = long_work();
  ChartOptions options = over(0, 30 * ms, -1);
  options.explanation = {{0, 30 * ms, "waits", "SM1", "", 0}, {0, 20 * ms, "works", "LS1", "", 1}};
  const SvgContent content = read_svg(svg(run, options));
  const SvgText* outer = text_with(content, "SM1: waits");
  const SvgText* inner = text_with(content, "LS1: works");
  REQUIRE(outer != nullptr);
  REQUIRE(inner != nullptr);
  CHECK(inner->box.x0 > outer->box.x0);
  CHECK(inner->box.y0 > outer->box.y0);
  CHECK(text_with(content, "b  ") == nullptr);
}

TEST_CASE("from a second on, times are in seconds") {
  CHECK(duration_text(8'010'400'000) == "8.0104 s");
  CHECK(duration_text(999'999'999) == "999.999999 ms");
}

TEST_CASE("a picture for a column is half as wide, with letters as large") {
  ChartOptions options = over(0, 30 * ms + 100 * us, 35 * ms);
  const SvgContent wide = read_svg(svg(long_work(), options));
  options.narrow = true;
  const SvgContent narrow = read_svg(svg(long_work(), options));
  CHECK(wide.width == 9'400);
  CHECK(narrow.width == 4'500);
  for (const SvgContent* each : {&wide, &narrow}) {
    REQUIRE(text_with(*each, "30.1 ms") != nullptr);
    for (const SvgText& text : each->texts) CHECK(text.box.x1 <= each->width);
  }
  const auto height = [](const SvgContent& content) {
    const Box& box = text_with(content, "30.1 ms")->box;
    return box.y1 - box.y0;
  };
  CHECK(height(narrow) == height(wide));
}

TEST_CASE("the change that a sample has just missed has a sign, and the key says so") {
  ChartOptions options = over(5 * ms, 30 * ms, -1);
  const auto signs = [&] {
    const SvgContent content = read_svg(svg(long_work(), options));
    return std::count_if(content.elements.begin(), content.elements.end(),
                         [](const SvgElement& element) { return element.style == "missed read"; });
  };
  CHECK(signs() == 0);
  options.highlight->missed = true;
  CHECK(signs() == 2);  // where it happens, and in the key
  const SvgContent content = read_svg(svg(long_work(), options));
  CHECK(text_with(content, "change that is just missed") != nullptr);
}

TEST_CASE("a message that was not taken is crossed out, and the key says so") {
  Timeline run = long_work();
  run.lanes.push_back({"camera", true, "", 0, {}, {}});
  run.lanes[1].bars = {bar(5 * ms, 20 * ms, "busy", BarKind::serving)};
  ChartOptions options;
  options.losses = {{"camera", 5 * ms, 20 * ms, "lost: no request for it was open when it began"}};
  const SvgContent content = read_svg(svg(run, options));
  const auto crossed = std::count_if(content.elements.begin(), content.elements.end(),
                                     [](const SvgElement& element) { return element.style == "loss"; });
  CHECK(crossed == 2);  // the frame, and the sign in the key
  CHECK(text_with(content, "lost: not taken") != nullptr);
  CHECK(std::none_of(content.texts.begin(), content.texts.end(),
                     [](const SvgText& text) { return text.content == "busy"; }));
}

}  // namespace
}  // namespace pal::analyzer::chart
