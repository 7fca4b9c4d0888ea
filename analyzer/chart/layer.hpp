// A run as one layer of a picture: a chart has one, an overlay two.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "analyzer/chart/options.hpp"
#include "analyzer/chart/text_width.hpp"
#include "analyzer/chart/timeline.hpp"

namespace pal::analyzer::chart {

enum class Role : std::uint8_t {
  only,      // nothing else in the picture
  backdrop,  // the proved run, outlined
  front,     // the measured run, solid, in the lower half of each lane
};

/// Instants of the layer's run are drawn at instant + shift_ns. rows[i] is the row of lane i. waves[i] is
/// that of waveform i. -1: not drawn.
struct Layer {
  const Timeline* timeline = nullptr;
  const ChartOptions* options = nullptr;
  Role role = Role::only;
  std::int64_t shift_ns = 0;
  std::vector<std::int64_t> rows;
  std::vector<std::int64_t> waves;
};

/// Right edge of time, and of texts; the left one is the margin's.
inline Length panel_right(const std::vector<Layer>& layers) {
  constexpr Length wide = 9250;
  constexpr Length narrow = 4350;
  return layers.front().options->narrow ? narrow : wide;
}

}  // namespace pal::analyzer::chart
