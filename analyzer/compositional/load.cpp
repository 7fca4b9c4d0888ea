// How much of its time a processor is busy.
#include <algorithm>

#include "analyzer/compositional/measures.hpp"

namespace pal::analyzer::compositional {

Bound load_bound(const View& view, const Requirement& requirement) {
  constexpr Nanoseconds second = 1'000'000'000;
  std::vector<Nanoseconds> busy(view.problem.processors.size(), 0);
  for (const Node& node : view.forest.nodes) {
    const Segment& segment = view.forest.segment_of(node);
    const Source& source = view.forest.sources[static_cast<std::size_t>(node.source)];
    if (source.period == never || segment.worst == 0) continue;
    const auto thread = static_cast<std::size_t>(segment.beginning.thread);
    Nanoseconds& sum = busy[static_cast<std::size_t>(view.problem.threads[thread].processor)];
    // Rounded up; more than the whole time is the whole time.
    const Nanoseconds times = source.period / segment.worst;
    const Nanoseconds share =
        times < 1 ? second
                  : static_cast<Nanoseconds>((segment.worst * second + source.period - 1) / source.period);
    sum = std::min(second, sum + share);
  }
  Nanoseconds most = 0;
  for (int processor : requirement.processors)
    most = std::max(most, busy[static_cast<std::size_t>(processor)]);
  return {most, most == second ? "the rates that are known add up to the whole time" : ""};
}

Bound busy_bound(const View& view, const Requirement& requirement) {
  Nanoseconds longest = 0;
  for (int processor : requirement.processors)
    longest = std::max(longest, view.times.windows.busy(processor));
  return {longest, "a processor may have work without end"};
}

}  // namespace pal::analyzer::compositional
