// The marks of lost messages.
#include <algorithm>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/panel.hpp"

namespace pal::analyzer::chart {

namespace {

// An event takes no time: its cross does.
constexpr Length least_cross = 90;

}  // namespace

void Panel::draw_losses(const Layer& layer) {
  const std::vector<Lane>& lanes = layer.timeline->lanes;
  for (const Loss& loss : layer.options->losses) {
    if (!touches(layer, loss.from_ns, loss.to_ns)) continue;
    const auto lane =
        std::find_if(lanes.begin(), lanes.end(), [&](const Lane& it) { return it.name == loss.lane; });
    const auto index = static_cast<std::size_t>(lane - lanes.begin());
    if (lane == lanes.end() || layer.rows[index] < 0) continue;
    Box box = bar_box(layer, index, loss.from_ns, loss.to_ns);
    if (box.x1 - box.x0 < least_cross) {
      box.x0 -= least_cross / 2;
      box.x1 = box.x0 + least_cross;
    }
    const std::string title = loss.lane + ": " + loss.text + "\n" + at(loss.from_ns + layer.shift_ns) +
                              " to " + at(loss.to_ns + layer.shift_ns);
    out_.path(move_to({box.x0, box.y0}) + line_to({box.x1, box.y1}) + move_to({box.x0, box.y1}) +
                  line_to({box.x1, box.y0}),
              layer.role == Role::backdrop ? "loss backdrop" : "loss", title);
    const Length half = text_width("lost", bar_font, true) / 2 + 25;
    const TimeScale::Stretch room = scale_.widest(box.x0, box.x1);
    if (2 * half + 60 > room.x1 - room.x0) continue;
    const Length middle = (room.x0 + room.x1) / 2;
    out_.rect({middle - half, box.y0 + 20, middle + half, box.y1 - 20}, "paper");
    out_.text({middle, (box.y0 + box.y1) / 2 + 30}, Anchor::middle, "on-light strong", "lost", title);
  }
}

}  // namespace pal::analyzer::chart
