// A measured run laid over the proved one.
#include <algorithm>
#include <numeric>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/page.hpp"

namespace pal::analyzer::chart {

namespace {

std::int64_t zero(const std::optional<std::int64_t>& given, const ChartOptions& options) {
  if (given) return *given;
  return options.highlight ? options.highlight->from_ns : 0;
}

// For each of `things`, the index of the one of the same name among `rows`; -1: there is none.
template <class Thing>
std::vector<std::int64_t> places(const std::vector<Thing>& things, const std::vector<Thing>& rows) {
  std::vector<std::int64_t> result;
  for (const Thing& thing : things) {
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const Thing& row) { return row.name == thing.name; });
    result.push_back(found == rows.end() ? -1 : found - rows.begin());
  }
  return result;
}

}  // namespace

std::string overlay_svg(const Timeline& proved, const Timeline& measured, const OverlayOptions& options) {
  Layer back{&proved, &options.proved, Role::backdrop, -zero(options.proved_zero_ns, options.proved), {}, {}};
  Layer front{
      &measured, &options.measured, Role::front, -zero(options.measured_zero_ns, options.measured), {}, {}};
  back.rows = places(proved.lanes, proved.lanes);
  back.waves = places(proved.waveforms, proved.waveforms);
  front.rows = places(measured.lanes, proved.lanes);
  front.waves = places(measured.waveforms, proved.waveforms);
  return page({back, front});
}

}  // namespace pal::analyzer::chart
