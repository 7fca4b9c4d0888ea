// Pieces of time in which threads wait, or are ready and have no processor.
#include <algorithm>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/panel.hpp"

namespace pal::analyzer::chart {

namespace {

constexpr Length gap_font = 85;

}  // namespace

void Panel::draw_gaps(const Layer& layer) {
  for (std::size_t i = 0; i < layer.timeline->lanes.size(); ++i) {
    if (layer.rows[i] < 0) continue;
    const Lane& lane = layer.timeline->lanes[i];
    for (const Gap& gap : lane.gaps) {
      if (!touches(layer, gap.from_ns, gap.to_ns)) continue;
      if (crowd_at(layer, i, gap.from_ns, gap.to_ns) != nullptr) continue;
      const Box box = bar_box(layer, i, gap.from_ns, gap.to_ns);
      const std::string span = "\n" + at(gap.from_ns + layer.shift_ns) + " to " +
                               at(gap.to_ns + layer.shift_ns) + " (" +
                               duration_text(gap.to_ns - gap.from_ns) + ")";
      if (layer.role != Role::backdrop) {
        const Length middle = (box.y0 + box.y1) / 2;
        labels_.take(gap.kind == GapKind::ready ? box : Box{box.x0, middle - 10, box.x1, middle + 10});
      }
      if (gap.kind == GapKind::ready) {
        out_.rect(box, layer.role == Role::backdrop ? "ready backdrop" : "ready",
                  lane.name + " is ready, but its processor is taken: " + gap.text + span);
        continue;
      }
      const Length middle = layer.role == Role::backdrop ? box.y0 + 10 : (box.y0 + box.y1) / 2;
      out_.line({box.x0, middle}, {box.x1, middle}, layer.role == Role::backdrop ? "wait backdrop" : "wait",
                lane.name + " waits for " + gap.text + (gap.gave_up ? ", and gives up" : "") + span);
      if (gap.gave_up && touches(layer, gap.to_ns, gap.to_ns)) {
        out_.path(move_to({box.x1 - 35, middle - 35}) + line_to({box.x1 + 35, middle + 35}) +
                      move_to({box.x1 - 35, middle + 35}) + line_to({box.x1 + 35, middle - 35}),
                  "gave-up", lane.name + " gives up waiting for " + gap.text);
      }
    }
  }
}

void Panel::label_gaps(const Layer& layer) {
  if (layer.role == Role::backdrop) return;
  for (std::size_t i = 0; i < layer.timeline->lanes.size(); ++i) {
    if (layer.rows[i] < 0) continue;
    const Row& row = rows_[static_cast<std::size_t>(layer.rows[i])];
    for (const Gap& gap : layer.timeline->lanes[i].gaps) {
      if (touches(layer, gap.from_ns, gap.to_ns) && crowd_at(layer, i, gap.from_ns, gap.to_ns) == nullptr)
        label_gap(layer, gap, row);
    }
  }
}

// In the first unfolded stretch that has room: above a wait's line, or into a ready bar, which is hatched, on
// paper.
void Panel::label_gap(const Layer& layer, const Gap& gap, const Row& row) {
  const bool ready = gap.kind == GapKind::ready;
  const std::string text = (ready ? "ready: " : "waits for ") + gap.text;
  const Length width = text_width(text, gap_font);
  const Length line =
      layer.role == Role::front ? (row.bar_top + 3 * row.bar_bottom) / 4 : (row.bar_top + row.bar_bottom) / 2;
  const Length base = line + (ready ? 30 : -35);
  for (const TimeScale::Piece& piece : scale_.pieces()) {
    if (piece.folded) continue;
    const Length left = std::max(piece.x0, x(layer, gap.from_ns));
    const Length right = std::min(piece.x1, x(layer, gap.to_ns));
    for (const Length at : gap_label_places(layer, left, right)) {
      if (at + width + 60 > right) continue;
      const Box box{at, base - 75, at + width, base + 20};
      // A ready bar is taken already: by itself, for its own label.
      if (!ready && !labels_.claim(box)) continue;
      if (ready) out_.rect({box.x0 - 15, box.y0 - 10, box.x1 + 15, box.y1 + 10}, "paper");
      out_.text({box.x0, base}, Anchor::start, "quiet", text);
      return;
    }
  }
}

/// At the beginning of a gap's part in [left, right], or behind an edge of the interval.
std::vector<Length> Panel::gap_label_places(const Layer& layer, Length left, Length right) const {
  std::vector<Length> places{left + 60};
  if (!layer.options->highlight) return places;
  for (const std::int64_t edge : {layer.options->highlight->from_ns, layer.options->highlight->to_ns}) {
    const Length at = x(layer, edge) + 40;
    if (at > left + 60 && at < right) places.push_back(at);
  }
  return places;
}

}  // namespace pal::analyzer::chart
