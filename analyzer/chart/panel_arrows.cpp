// The arrows of messages between lanes.
#include <algorithm>
#include <cstdlib>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/panel.hpp"
#include "analyzer/chart/promises.hpp"

namespace pal::analyzer::chart {

namespace {

constexpr Length small_font = 85;
constexpr Length event_width = 90;

std::string arrow_style(const Arrow& arrow, Role role) {
  std::string style = "arrow";
  if (arrow.fate == Fate::dropped) style += " dropped";
  if (arrow.fate == Fate::undelivered) style += " undelivered";
  if (role == Role::backdrop) style += " backdrop";
  return style;
}

std::string cross(Point at, Length size) {
  return move_to({at.x - size, at.y - size}) + line_to({at.x + size, at.y + size}) +
         move_to({at.x - size, at.y + size}) + line_to({at.x + size, at.y - size});
}

}  // namespace

bool Panel::arrow_ends(const Layer& layer, const Arrow& arrow, Point& from, Point& to) const {
  if (arrow.to_lane < 0 || !touches(layer, arrow.from_ns, arrow.from_ns)) return false;
  if (!touches(layer, arrow.to_ns, arrow.to_ns)) return false;
  const std::int64_t a = layer.rows[arrow.from_lane];
  const std::int64_t b = layer.rows[static_cast<std::size_t>(arrow.to_lane)];
  if (a < 0 || b < 0 || a == b) return false;
  const bool kept = is_edge(layer, arrow.from_ns) || is_edge(layer, arrow.to_ns);
  if (!kept &&
      (crowd_at(layer, arrow.from_lane, arrow.from_ns, arrow.from_ns) != nullptr ||
       crowd_at(layer, static_cast<std::size_t>(arrow.to_lane), arrow.to_ns, arrow.to_ns) != nullptr))
    return false;
  const Box sender = bar_box(layer, arrow.from_lane, arrow.from_ns, arrow.from_ns);
  const Box receiver = bar_box(layer, static_cast<std::size_t>(arrow.to_lane), arrow.to_ns, arrow.to_ns);
  const bool down = a < b;
  from = {sender.x0, down ? sender.y1 : sender.y0};
  to = {receiver.x0, down ? receiver.y0 : receiver.y1};
  return true;
}

void Panel::draw_arrows(const Layer& layer) {
  for (const Arrow& arrow : layer.timeline->arrows) {
    Point from;
    Point to;
    if (!arrow_ends(layer, arrow, from, to)) continue;
    const std::string title = arrow.message + ": " + layer.timeline->lanes[arrow.from_lane].name + " to " +
                              layer.timeline->lanes[static_cast<std::size_t>(arrow.to_lane)].name + "\nput " +
                              at(arrow.from_ns + layer.shift_ns) +
                              (arrow.fate == Fate::dropped ? ", withdrawn " : ", taken ") +
                              at(arrow.taken_ns + layer.shift_ns);
    out_.line(from, to, arrow_style(arrow, layer.role), title);
    if (arrow.fate == Fate::dropped) out_.path(cross(to, 30), "gave-up", title);
  }
}

// Labels stay clear of the arrows of the run that they belong to: of each, a chain of small boxes.
void Panel::keep_off_arrows(const Layer& layer) {
  if (layer.role == Role::backdrop) return;
  for (const Arrow& arrow : layer.timeline->arrows) {
    Point from;
    Point to;
    if (!arrow_ends(layer, arrow, from, to)) continue;
    const Length pieces = std::abs(to.y - from.y) / 50 + 1;
    for (Length i = 0; i <= pieces; ++i) {
      const Point on{from.x + (to.x - from.x) * i / pieces, from.y + (to.y - from.y) * i / pieces};
      labels_.take({on.x - 12, on.y - 20, on.x + 12, on.y + 20});
    }
  }
}

// Points of an arrow beside which its label may stand, best first. The best ones are between two lanes, as
// near to the arrow's middle as possible. Then comes any point.
std::vector<Point> Panel::label_places(Point from, Point to) const {
  std::vector<Point> places;
  const auto at = [&](Length y) {
    const Length x = to.y == from.y ? from.x : from.x + (to.x - from.x) * (y - from.y) / (to.y - from.y);
    places.push_back({x, y});
  };
  const auto [top, bottom] = std::minmax(from.y, to.y);
  for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
    const Length y = rows_[i].bar_bottom + 60;
    if (y - 50 >= top && y + 45 <= bottom && y + 45 <= rows_[i + 1].bar_top) at(y);
  }
  const Length middle = (top + bottom) / 2;
  std::stable_sort(places.begin(), places.end(), [middle](const Point& a, const Point& b) {
    return std::abs(a.y - middle) < std::abs(b.y - middle);
  });
  for (const int percent : {50, 35, 65, 20, 80}) at(from.y + (to.y - from.y) * percent / 100);
  return places;
}

void Panel::label_arrows(const Layer& layer) {
  if (layer.role == Role::backdrop) return;
  for (const Arrow& arrow : layer.timeline->arrows) {
    Point from;
    Point to;
    if (!arrow_ends(layer, arrow, from, to)) continue;
    // A device's event has its name at its mark.
    const auto& marks = layer.timeline->marks;
    if (std::any_of(marks.begin(), marks.end(), [&](const Mark& mark) {
          return mark.kind == MarkKind::event && mark.at_ns == arrow.from_ns && mark.text == arrow.message;
        })) {
      continue;
    }
    const Length width = text_width(arrow.message, small_font);
    // Beside a slanted arrow a label needs more distance than beside an upright one.
    const Length slant = to.y == from.y ? 0 : 45 * std::abs(to.x - from.x) / std::abs(to.y - from.y);
    const Length aside = 30 + std::min<Length>(slant, 200);
    bool placed = false;
    for (const bool right : {true, false}) {
      for (const Point& on : label_places(from, to)) {
        const Length left = right ? on.x + aside : on.x - aside - width;
        if (placed || left < scale_.x0() || left + width > scale_.x1()) continue;
        placed = labels_.claim({left - 5, on.y - 45, left + width + 5, on.y + 50});
        if (placed) out_.text({left, on.y + 28}, Anchor::start, "message-name", arrow.message);
      }
    }
  }
}

// Above the lanes, in one of two rows, to the right or left of its line.
void Panel::label_mark(const std::string& text, Length place) {
  const Length width = text_width(text, small_font);
  for (const Length base : {lanes_top_ - 20, lanes_top_ - 140}) {
    for (const Length left : {place + 30, place - 30 - width}) {
      if (left < scale_.x0() || left + width > scale_.x1()) continue;
      if (!labels_.claim({left, base - 75, left + width, base + 20})) continue;
      out_.text({left, base}, Anchor::start, "small", text);
      return;
    }
  }
}

// In its lane. A promise that no single lane broke is drawn above the lanes.
void Panel::draw_promise(const Layer& layer, const Mark& mark, Length place) {
  Length y = lanes_top_;
  std::string who;
  if (mark.lane >= 0) {
    const auto lane = static_cast<std::size_t>(mark.lane);
    if (layer.rows[lane] < 0) return;
    const Box box = bar_box(layer, lane, mark.at_ns, mark.at_ns);
    y = (box.y0 + box.y1) / 2;
    who = layer.timeline->lanes[lane].name + ": ";
  }
  const std::vector<BrokenPromise> all = broken_promises(layers_);
  const auto promise =
      std::find_if(all.begin(), all.end(), [&](const BrokenPromise& each) { return each.text == mark.text; });
  const auto number = static_cast<std::size_t>(promise - all.begin()) + 1;
  draw_promise_sign({place, y}, number, layer.role == Role::backdrop ? "broken backdrop" : "broken",
                    who + "promise broken: " + mark.text + "\n" + at(mark.at_ns + layer.shift_ns), out_);
  labels_.take({place - 60, y - 60, place + 60, y + 60});
}

void Panel::draw_marks(const Layer& layer) {
  std::map<std::int64_t, Length> last;  // event that was drawn, by lane
  for (const Mark& mark : layer.timeline->marks) {
    if (!touches(layer, mark.at_ns, mark.at_ns)) continue;
    const Length place = x(layer, mark.at_ns);
    const std::string when = at(mark.at_ns + layer.shift_ns);
    if (mark.kind == MarkKind::broken) {
      draw_promise(layer, mark, place);
      continue;
    }
    if (mark.lane < 0 || mark.kind == MarkKind::completion || mark.kind == MarkKind::fault) {
      const std::string style = mark.kind == MarkKind::fault ? "ending fault" : "ending";
      out_.line({place, lanes_top_}, {place, lanes_bottom_}, style, mark.text + "\n" + when);
      label_mark(mark.text, place);
      continue;
    }
    const auto lane = static_cast<std::size_t>(mark.lane);
    if (layer.rows[lane] < 0) continue;
    const Box box = bar_box(layer, lane, mark.at_ns, mark.at_ns);
    const std::string title = layer.timeline->lanes[lane].name + ": " + mark.text + "\n" + when;
    const std::string faded = layer.role == Role::backdrop ? " backdrop" : "";
    const Length middle = (box.y0 + box.y1) / 2;
    if (mark.kind == MarkKind::event) {
      const auto before = last.find(mark.lane);
      const bool near = before != last.end() && place - before->second < event_width;
      if (near && has_crowds(layer) && !is_edge(layer, mark.at_ns)) continue;
      last[mark.lane] = place;
      out_.path(
          move_to({place - 45, box.y0}) + line_to({place + 45, box.y0}) + line_to({place, box.y1}) + "Z",
          "event" + faded, title);
      const Length width = text_width(mark.text, bar_font);
      for (const Length left : {place + 60, place - 60 - width}) {
        if (layer.role == Role::backdrop || left < scale_.x0() || left + width > scale_.x1()) continue;
        if (!labels_.claim({left, middle - 50, left + width, middle + 50})) continue;
        out_.text({left, middle + 30}, Anchor::start, "on-light", mark.text, title);
        break;
      }
    } else if (mark.kind == MarkKind::overrun) {
      out_.path(cross({place, middle}, 45), "overrun" + faded, title);
    } else if (mark.kind == MarkKind::cancelled) {
      out_.line({place, box.y0}, {place, box.y1}, "cancelled" + faded, title);
    }
  }
}

}  // namespace pal::analyzer::chart
