#include "analyzer/chart/numbering.hpp"

#include <filesystem>
#include <set>

namespace pal::analyzer::chart {

bool text_fits(const Bar& bar, std::int64_t shift_ns, const TimeScale& scale) {
  const Length room = scale.x(bar.to_ns + shift_ns) - scale.x(bar.from_ns + shift_ns);
  return text_width(bar.text, bar_font) + 40 <= room;
}

Numbering::Key Numbering::key(const Lane& lane, const Bar& bar) {
  return {lane.name, std::filesystem::path(bar.file).filename().string(), bar.line, bar.text};
}

Numbering::Numbering(const std::vector<Layer>& layers, const TimeScale& scale) {
  // The lanes of the first layer set the order; lanes that only a later one has come after them.
  std::vector<std::string> order;
  std::map<std::string, std::set<Key>> wanted;
  for (const Layer& layer : layers) {
    for (const Lane& lane : layer.timeline->lanes) {
      if (lane.device) continue;
      if (wanted.find(lane.name) == wanted.end()) order.push_back(lane.name);
      std::set<Key>& keys = wanted[lane.name];
      for (const Bar& bar : lane.bars) {
        const std::int64_t edge = bar.to_ns - bar.from_ns >= 2 ? 1 : 0;
        const bool shown =
            scale.touches(bar.from_ns + layer.shift_ns + edge, bar.to_ns + layer.shift_ns - edge);
        if (shown && !text_fits(bar, layer.shift_ns, scale)) keys.insert(key(lane, bar));
      }
    }
  }
  for (const std::string& lane : order) {
    for (const Key& key : wanted[lane]) {
      const int number = static_cast<int>(entries_.size()) + 1;
      numbers_[key] = number;
      entries_.push_back({number, lane, std::get<3>(key)});
    }
  }
}

int Numbering::number(const Lane& lane, const Bar& bar) const {
  const auto found = numbers_.find(key(lane, bar));
  return found == numbers_.end() ? 0 : found->second;
}

}  // namespace pal::analyzer::chart
