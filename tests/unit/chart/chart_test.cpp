#include <catch2/catch.hpp>
#include <fstream>

#include "analyzer/chart/chart.hpp"
#include "tests/unit/chart/touch_trace.hpp"

namespace pal::chart {
namespace {

void save(const std::string& name, const std::string& text) {
  std::ofstream(std::string(PAL_BINARY_DIR) + "/" + name, std::ios::binary) << text;
}

struct Example {
  Timeline timeline;
  ChartOptions options;
};

Example worst(TouchRun run) {
  // The phase for which the value is oldest.
  std::int64_t longest = 0;
  std::int64_t best = 0;
  for (run.tick_ns = 0; run.tick_ns < 28'000'000; run.tick_ns += 50'000) {
    const Oldest it = oldest_force(touch_trace(run));
    if (it.sent_ns - it.set_ns > longest) {
      longest = it.sent_ns - it.set_ns;
      best = run.tick_ns;
    }
  }
  run.tick_ns = best;
  const trace::Trace trace = touch_trace(run);
  const Oldest oldest = oldest_force(trace);
  Example example{chart::timeline(trace), {}};
  const std::int64_t age = oldest.sent_ns - oldest.set_ns;
  const std::int64_t limit = 10'000'000;
  example.options.caption = {"fresh-force",
                             "age of pc-force at TXM( motion to MC1 ) in SM1",
                             age <= limit ? "holds" : "fails",
                             age,
                             true,
                             limit};
  example.options.highlight = Highlight{oldest.set_ns, oldest.sent_ns, "age of pc-force", age > limit, limit};
  return example;
}

TEST_CASE("examples") {
  Example good = worst({});
  save("touch.svg", svg(good.timeline, good.options));
  save("touch.txt", dump(good.timeline));
  Example bad = worst({true});
  const Highlight& h = *bad.options.highlight;
  bad.options.explanation = {
      {h.from_ns, h.from_ns + 6'000'000, "the sensor works while nobody needs it", "SD1"},
      {h.from_ns + 6'000'000, h.to_ns - 500'000, "waits for the request of MC1", "SM1.2"},
      {h.to_ns - 500'000, h.to_ns, "computes the motion", "SM1.2"}};
  save("touch_read_first.svg", svg(bad.timeline, bad.options));
  Example zero = worst({true, true});
  save("touch_read_first_no_costs.svg", svg(zero.timeline, zero.options));
  TouchRun run;
  run.percent = 90;
  run.tick_ns = 9'100'000;
  Example measured = worst(run);
  save("touch_overlay.svg",
       overlay_svg(good.timeline, measured.timeline, {good.options, measured.options, {}, {}}));
}

}  // namespace
}  // namespace pal::chart
