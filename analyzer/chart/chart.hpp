// Charts of runs as SVG (docs/reference/charts.md). They are readable in black and white, and text is text.
// The same input gives the same bytes.
#pragma once

#include <optional>
#include <string>

#include "analyzer/chart/options.hpp"
#include "analyzer/chart/timeline.hpp"

namespace pal::analyzer::chart {

/// A picture of one run, 940 pixels wide: legible on a page of A4; if `narrow`, 450, for half of it. Names in
/// `options` that the timeline does not have are drawn as text only.
std::string svg(const Timeline& timeline, const ChartOptions& options);

struct OverlayOptions {
  /// What to point out in each of the two runs; the caption and the window are those of `proved`.
  ChartOptions proved;
  ChartOptions measured;
  /// Instants of the two runs that are drawn at one place, as time 0. If not given: the beginnings of the two
  /// highlighted intervals, or of the runs.
  std::optional<std::int64_t> proved_zero_ns;
  std::optional<std::int64_t> measured_zero_ns;
};

/// The measured run (solid, lower half of each lane) over the proved one (outlined). Lanes are matched by
/// name.
std::string overlay_svg(const Timeline& proved, const Timeline& measured, const OverlayOptions& options);

/// "7.35 ms": exact to the nanosecond, in the unit that reads best, without trailing zeros.
std::string duration_text(std::int64_t ns);

/// The same, rounded to the nearest microsecond from 0.1 ms on: for what was measured.
std::string rounded_duration_text(std::int64_t ns);

}  // namespace pal::analyzer::chart
