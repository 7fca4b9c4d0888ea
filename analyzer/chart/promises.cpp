#include "analyzer/chart/promises.hpp"

#include <algorithm>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/legend.hpp"
#include "analyzer/chart/panel.hpp"

namespace pal::analyzer::chart {

namespace {

constexpr Length list_edge = 40;
constexpr Length list_row = 135;
constexpr Length list_font = 90;
constexpr Length sign_size = 58;

}  // namespace

std::vector<BrokenPromise> broken_promises(const std::vector<Layer>& layers) {
  std::vector<BrokenPromise> all;
  for (const Layer& layer : layers) {
    for (const Mark& mark : layer.timeline->marks) {
      if (mark.kind != MarkKind::broken) continue;
      const auto known = std::find_if(all.begin(), all.end(),
                                      [&](const BrokenPromise& each) { return each.text == mark.text; });
      BrokenPromise& promise =
          known != all.end() ? *known
                             : all.emplace_back(BrokenPromise{mark.text, mark.at_ns + layer.shift_ns, 0});
      ++promise.times;
    }
  }
  return all;
}

void draw_promise_sign(Point middle, std::size_t number, const std::string& style, const std::string& title,
                       SvgWriter& out) {
  out.path(move_to({middle.x, middle.y - sign_size}) + line_to({middle.x + sign_size, middle.y}) +
               line_to({middle.x, middle.y + sign_size}) + line_to({middle.x - sign_size, middle.y}) + "Z",
           style, title);
  out.text({middle.x, middle.y + 28}, Anchor::middle, "on-light strong", std::to_string(number), title);
}

Length draw_promise_list(const std::vector<Layer>& layers, Length top, SvgWriter& out) {
  const std::vector<BrokenPromise> all = broken_promises(layers);
  if (all.empty()) return top;
  top = draw_panel_heading("Broken promises of the environment", top, out) + 60;
  std::vector<std::string> when;
  Length widest = 0;
  for (const BrokenPromise& each : all) {
    const std::string more = each.times > 1 ? ", " + std::to_string(each.times) + " times" : "";
    when.push_back((each.times > 1 ? "first at " : "at ") + rounded_duration_text(each.first_ns) + more);
    widest = std::max(widest, text_width(when.back(), list_font));
  }
  const Length x = list_edge + 240;
  const Length room = panel_right(layers) - x - widest - 150;
  Length y = top;
  for (std::size_t i = 0; i < all.size(); ++i) {
    y += list_row;
    draw_promise_sign({list_edge + sign_size, y - 30}, i + 1, "broken", "", out);
    out.text({x, y}, Anchor::start, "key", when[i]);
    const std::vector<std::string> lines = wrapped(all[i].text, list_font, room);
    for (std::size_t line = 0; line < lines.size(); ++line) {
      if (line > 0) y += list_row;
      out.text({x + widest + 150, y}, Anchor::start, "key", lines[line]);
    }
  }
  return y + 60;
}

}  // namespace pal::analyzer::chart
