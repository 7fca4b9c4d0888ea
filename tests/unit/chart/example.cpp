#include "tests/unit/chart/example.hpp"

#include "analyzer/chart/chart.hpp"

namespace pal::analyzer::chart {

Example example_of(const trace::Trace& trace) {
  const Oldest oldest = oldest_force(trace);
  Example example{timeline(trace), {}};
  const std::int64_t age = oldest.sent_ns - oldest.set_ns;
  const std::int64_t limit = 10'000'000;
  const bool holds = age <= limit;
  example.options.caption.requirement = "fresh-force";
  example.options.caption.measure = "age of pc-force at TXM( motion to MC1 ) in SM1";
  example.options.caption.verdict = holds ? "holds" : "fails";
  example.options.caption.figures =
      "worst case " + duration_text(age) + " (exact: the run below attains it), limit 10 ms, " +
      (holds ? "margin " + duration_text(limit - age) : duration_text(age - limit) + " too much");
  example.options.caption.proved = "at most " + duration_text(age);
  example.options.caption.limit = "10 ms";
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

}  // namespace pal::analyzer::chart
