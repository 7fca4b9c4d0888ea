// A timeline as SVG: its parts, put together.
#include <numeric>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/page.hpp"

namespace pal::analyzer::chart {

std::string svg(const Timeline& timeline, const ChartOptions& options) {
  Layer layer{&timeline, &options, Role::only, 0, {}, {}};
  layer.rows.resize(timeline.lanes.size());
  layer.waves.resize(timeline.waveforms.size());
  std::iota(layer.rows.begin(), layer.rows.end(), std::int64_t{0});
  std::iota(layer.waves.begin(), layer.waves.end(), std::int64_t{0});
  return page({layer});
}

}  // namespace pal::analyzer::chart
