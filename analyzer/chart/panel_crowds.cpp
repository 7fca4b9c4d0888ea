// Crowds: many short actions close together on a lane, drawn as one block where each by itself would show
// nothing.
#include <algorithm>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/panel.hpp"

namespace pal::analyzer::chart {

namespace {

/// Fewer are drawn one by one.
constexpr std::size_t least_crowd = 4;

}  // namespace

// The ends of what the chart is about are never part of a crowd.
bool Panel::is_edge(const Layer& layer, std::int64_t ns) {
  const auto& highlight = layer.options->highlight;
  return highlight && (ns == highlight->from_ns || ns == highlight->to_ns);
}

void Panel::find_crowds(const Layer& layer) {
  std::vector<std::vector<Crowd>>& found = crowds_[&layer];
  found.resize(layer.timeline->lanes.size());
  if (style_.crowd == 0) return;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (layer.rows[i] < 0) continue;
    const std::vector<Bar>& bars = layer.timeline->lanes[i].bars;
    Crowd now;
    Length end = 0;
    const auto flush = [&] {
      if (now.bars >= least_crowd) found[i].push_back(now);
      now = {};
    };
    for (std::size_t b = 0; b < bars.size(); ++b) {
      const Bar& bar = bars[b];
      const Box box = bar_box(layer, i, bar.from_ns, bar.to_ns);
      if (!touches(layer, bar.from_ns, bar.to_ns) || box.x1 - box.x0 > style_.crowd ||
          is_edge(layer, bar.from_ns) || is_edge(layer, bar.to_ns)) {
        flush();
        continue;
      }
      if (now.bars > 0 && box.x0 - end > style_.crowd) flush();
      if (now.bars == 0) now = {b, 0, bar.from_ns, bar.to_ns};
      ++now.bars;
      now.to_ns = bar.to_ns;
      end = box.x1;
    }
    flush();
  }
}

const Panel::Crowd* Panel::crowd_at(const Layer& layer, std::size_t lane, std::int64_t from_ns,
                                    std::int64_t to_ns) const {
  const auto& all = crowds_.at(&layer)[lane];
  const auto next = std::upper_bound(all.begin(), all.end(), from_ns,
                                     [](std::int64_t ns, const Crowd& crowd) { return ns < crowd.from_ns; });
  if (next == all.begin()) return nullptr;
  const Crowd& crowd = *std::prev(next);
  return to_ns <= crowd.to_ns ? &crowd : nullptr;
}

bool Panel::has_crowds(const Layer& layer) const {
  const auto& lanes = crowds_.at(&layer);
  return std::any_of(lanes.begin(), lanes.end(), [](const auto& crowds) { return !crowds.empty(); });
}

void Panel::draw_crowd(const Layer& layer, std::size_t lane, const Crowd& crowd) {
  const Box box = bar_box(layer, lane, crowd.from_ns, crowd.to_ns);
  out_.rect(box, layer.role == Role::backdrop ? "crowd backdrop" : "crowd",
            layer.timeline->lanes[lane].name + ": " + std::to_string(crowd.bars) + " actions\n" +
                at(crowd.from_ns + layer.shift_ns) + " to " + at(crowd.to_ns + layer.shift_ns));
  if (layer.role != Role::backdrop) labels_.take(box);
}

}  // namespace pal::analyzer::chart
