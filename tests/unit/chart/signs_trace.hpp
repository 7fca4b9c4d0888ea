// One short run with one of everything that a chart can show.
#pragma once

#include "pal/trace/trace.hpp"

namespace pal::analyzer::chart {

trace::Trace signs_trace();

}  // namespace pal::analyzer::chart
