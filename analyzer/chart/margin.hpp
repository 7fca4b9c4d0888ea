// The left margin of a chart, where the names stand.
#pragma once

#include <vector>

#include "analyzer/chart/layer.hpp"
#include "analyzer/chart/text_width.hpp"

namespace pal::analyzer::chart {

/// Where names and the time axis begin. Processors and devices begin at `group_x`.
struct Margin {
  static constexpr Length group_x = 40;
  Length name_x = 430;  // of threads, right of the brackets
  Length left = 1250;   // left edge of time
};

/// As wide as the names need, within reason: time keeps two thirds of the page.
Margin margin_for(const std::vector<Layer>& layers);

}  // namespace pal::analyzer::chart
