#include "analyzer/chart/margin.hpp"

#include <algorithm>

namespace pal::analyzer::chart {

namespace {

constexpr Length name_font = 110;
constexpr Length most_processor = 1300;
constexpr Length most_left = 2800;
// In a narrow picture.
constexpr Length most_narrow_processor = 700;
constexpr Length most_narrow_left = 1700;
// Between a processor's name and its threads' names: the bracket.
constexpr Length bracket_room = 150;
constexpr Length gap = 60;
// "FALSE" at the left end of a waveform.
constexpr Length value_room = 380;

}  // namespace

Margin margin_for(const std::vector<Layer>& layers) {
  Margin margin;
  Length processor = 0;
  Length thread = 0;
  Length other = 0;
  const bool narrow = layers.front().options->narrow;
  const Timeline& timeline = *layers.front().timeline;
  for (const Lane& lane : timeline.lanes) {
    if (lane.device) {
      other = std::max(other, text_width(lane.name, name_font) + gap);
      continue;
    }
    processor = std::max(processor, text_width(lane.processor, name_font, true));
    thread = std::max(thread, text_width(lane.name, name_font));
  }
  for (const Waveform& wave : timeline.waveforms)
    other = std::max(other, text_width(wave.name, name_font) + value_room);
  margin.name_x = std::max(
      margin.name_x,
      Margin::group_x + std::min(processor, narrow ? most_narrow_processor : most_processor) + bracket_room);
  const Length needed = std::max(margin.name_x + thread + gap, Margin::group_x + other);
  margin.left = std::max(margin.left, std::min(needed, narrow ? most_narrow_left : most_left));
  return margin;
}

}  // namespace pal::analyzer::chart
