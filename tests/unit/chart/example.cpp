#include "tests/unit/chart/example.hpp"

namespace pal::chart {

Example example_of(const trace::Trace& trace) {
  const Oldest oldest = oldest_force(trace);
  Example example{timeline(trace), {}};
  const std::int64_t age = oldest.sent_ns - oldest.set_ns;
  const std::int64_t limit = 10'000'000;
  example.options.caption = {"fresh-force",
                             "age of pc-force at TXM( motion to MC1 ) in SM1",
                             age <= limit ? "holds" : "fails",
                             age,
                             true,
                             limit};
  example.options.highlight = Highlight{oldest.set_ns, oldest.sent_ns, "age of pc-force", age > limit, limit};
  if (age > limit) {
    const std::int64_t asked = oldest.sent_ns - age / 50;
    example.options.explanation = {
        {oldest.set_ns, oldest.set_ns + 100'000, "reads pc-force and decides on it", "SM1.2", "touch.pal:10"},
        {oldest.set_ns + 100'000, asked, "waits at WTM( request motion from MC1 )", "SM1.2", "touch.pal:12"},
        {asked, oldest.sent_ns, "computes the motion and sends it", "SM1.2", "touch.pal:13"}};
  }
  return example;
}

Example worst_touch(TouchRun run) {
  std::int64_t longest = -1;
  std::int64_t phase = 0;
  for (run.tick_ns = 0; run.tick_ns < 28'000'000; run.tick_ns += 50'000) {
    const Oldest it = oldest_force(touch_trace(run));
    if (it.sent_ns - it.set_ns > longest) {
      longest = it.sent_ns - it.set_ns;
      phase = run.tick_ns;
    }
  }
  run.tick_ns = phase;
  return example_of(touch_trace(run));
}

}  // namespace pal::chart
