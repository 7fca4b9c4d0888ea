// Traces of the touch skill with what an analysis would say of them.
#pragma once

#include "analyzer/chart/options.hpp"
#include "analyzer/chart/timeline.hpp"
#include "tests/unit/chart/touch_trace.hpp"

namespace pal::analyzer::chart {

struct Example {
  Timeline timeline;
  ChartOptions options;
};

/// The run with its oldest force highlighted, limit 10 ms.
Example example_of(const trace::Trace& trace);

/// The same for the phase of ALTER (of 560) in which the force is oldest.
Example worst_touch(TouchRun run);

}  // namespace pal::analyzer::chart
