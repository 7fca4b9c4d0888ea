// The measured interval of a requirement, an age or a response, as a dimension line with its length.
#include <algorithm>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/panel.hpp"

namespace pal::analyzer::chart {

namespace {

constexpr Length figure_font = 105;

std::string figure(const Layer& layer, std::int64_t ns) {
  return layer.timeline->origin == "measured" ? rounded_duration_text(ns) : duration_text(ns);
}

const char* verdict_style(const Highlight& highlight) {
  return highlight.fails ? "fails" : "holds";
}

std::string dimension_style(const Layer& layer, const Highlight& highlight) {
  return std::string("dimension ") + verdict_style(highlight) +
         (layer.role == Role::backdrop ? " backdrop" : "");
}

}  // namespace

std::string segment_letter(std::size_t index) {
  const std::string last(1, static_cast<char>('a' + index % 26));
  return index < 26 ? last : segment_letter(index / 26 - 1) + last;
}

void Panel::draw_bands() {
  for (const Layer& layer : layers_) {
    if (!layer.options->highlight || layer.role == Role::backdrop) continue;
    const Highlight& highlight = *layer.options->highlight;
    const Length left = x(layer, highlight.from_ns);
    const Length right = std::max(x(layer, highlight.to_ns), left + 20);
    out_.rect({left, lanes_top_ - 20, right, bottom_}, std::string("band ") + verdict_style(highlight),
              highlight.label + " " + figure(layer, highlight.to_ns - highlight.from_ns));
  }
}

void Panel::draw_dimensions() {
  const Length first = (waves_.empty() ? lanes_bottom_ : waves_.back().top + style_.wave_height()) + 120;
  // All edges first, so that none is drawn through a figure.
  Length y = first;
  for (const Layer& layer : layers_) {
    if (!layer.options->highlight) continue;
    draw_edges(layer, *layer.options->highlight, y);
    y += dimension_row;
  }
  y = first;
  for (const Layer& layer : layers_) {
    if (!layer.options->highlight) continue;
    draw_dimension(layer, *layer.options->highlight, y);
    y += dimension_row;
  }
  if (!layers_.front().options->explanation.empty()) draw_segments(layers_.front(), y);
}

void Panel::keep_off_edges(const Layer& layer) {
  if (!layer.options->highlight) return;
  const Length left = x(layer, layer.options->highlight->from_ns);
  const Length right = std::max(x(layer, layer.options->highlight->to_ns), left + 20);
  for (const Length edge : {left, right}) labels_.take({edge - 7, lanes_top_, edge + 7, lanes_bottom_});
}

void Panel::draw_edges(const Layer& layer, const Highlight& highlight, Length y) {
  const Length left = x(layer, highlight.from_ns);
  const Length right = std::max(x(layer, highlight.to_ns), left + 20);
  for (const Length edge : {left, right}) {
    out_.line({edge, lanes_top_ - 20}, {edge, y + 40}, dimension_style(layer, highlight) + " edge");
  }
}

void Panel::draw_dimension(const Layer& layer, const Highlight& highlight, Length y) {
  const Length left = x(layer, highlight.from_ns);
  const Length right = std::max(x(layer, highlight.to_ns), left + 20);
  std::string text = highlight.label + " " + figure(layer, highlight.to_ns - highlight.from_ns);
  if (layer.role == Role::backdrop) text = "proved: " + text;
  if (layer.role == Role::front) text = "measured: " + text;
  out_.line({left, y}, {right, y}, dimension_style(layer, highlight) + " measure", text);
  const std::string ink = std::string("figure ") + verdict_style(highlight);
  const TimeScale::Stretch room = scale_.widest(left, right);
  // The figure alone, where there is no room for more.
  for (const std::string& words : {text, figure(layer, highlight.to_ns - highlight.from_ns)}) {
    const Length width = text_width(words, figure_font, true);
    if (width + 200 < room.x1 - room.x0) {
      const Length middle = (room.x0 + room.x1) / 2;
      out_.rect({middle - width / 2 - 40, y - 60, middle + width / 2 + 40, y + 60}, "paper");
      return out_.text({middle, y + 38}, Anchor::middle, ink, words, text);
    }
    if (right + 60 + width < scale_.x1())
      return out_.text({right + 60, y + 38}, Anchor::start, ink, words, text);
    if (left - 60 - width > Margin::group_x)
      return out_.text({left - 60, y + 38}, Anchor::end, ink, words, text);
  }
}

void Panel::draw_segments(const Layer& layer, Length y) {
  const std::vector<Segment>& segments = layer.options->explanation;
  std::size_t next = 0;
  for (const Segment& segment : segments) {
    if (segment.depth > 0) continue;
    const std::string letter = segment_letter(next++);
    if (!touches(layer, segment.from_ns, segment.to_ns)) continue;
    const Length left = x(layer, segment.from_ns);
    const Length right = x(layer, segment.to_ns);
    const std::string length = figure(layer, segment.to_ns - segment.from_ns);
    const std::string title = letter + ": " + length + " " + segment.text +
                              (segment.actor.empty() ? "" : " (" + segment.actor + ")");
    out_.path(move_to({left, y - 40}) + line_to({left, y + 40}) + move_to({left, y}) + line_to({right, y}) +
                  move_to({right, y - 40}) + line_to({right, y + 40}),
              "segment", title);
    for (const std::string& text :
         {letter + "  " + length + "  " + segment.text, letter + "  " + length, letter}) {
      const Length half = text_width(text, bar_font) / 2 + 25;
      const TimeScale::Stretch room = scale_.widest(left, right);
      const Length middle = (room.x0 + room.x1) / 2;
      if (2 * half + 30 > room.x1 - room.x0) continue;
      out_.rect({middle - half, y - 45, middle + half, y + 45}, "paper");
      out_.text({middle, y + 30}, Anchor::middle, "on-light", text, title);
      break;
    }
  }
}

std::string missed_change_sign(Point at) {
  return move_to(at) + line_to({at.x - 40, at.y - 100}) + line_to({at.x + 40, at.y - 100}) + "Z";
}

/// A reaction counts from here: no sample shows the change before the next one is taken.
void Panel::draw_missed_change(const Layer& layer) {
  if (!layer.options->highlight || !layer.options->highlight->missed) return;
  const std::int64_t from = layer.options->highlight->from_ns;
  if (!touches(layer, from, from)) return;
  const Length place = x(layer, from);
  out_.path(missed_change_sign({place, lanes_top_ - 20}), "missed read",
            "a change that the sample of this instant has just missed\n" + at(from + layer.shift_ns));
  labels_.take({place - 50, lanes_top_ - 130, place + 50, lanes_top_ - 10});
}

void Panel::draw_deadlines() {
  for (const Layer& layer : layers_) {
    if (layer.role == Role::front) continue;
    const auto& highlight = layer.options->highlight;
    if (highlight && highlight->limit_ns >= 0) {
      draw_deadline(highlight->from_ns + highlight->limit_ns + layer.shift_ns,
                    "limit " + duration_text(highlight->limit_ns));
    }
    for (const Deadline& deadline : layer.options->deadlines)
      draw_deadline(deadline.at_ns + layer.shift_ns, deadline.label);
  }
}

void Panel::draw_deadline(std::int64_t at_ns, const std::string& label) {
  if (at_ns > scale_.to_ns()) return point_to_deadline(at_ns, label);
  if (!scale_.shows(at_ns)) return;
  const Length place = scale_.x(at_ns);
  const std::string title = label + "\n" + at(at_ns);
  out_.line({place, lanes_top_ - 90}, {place, bottom_}, "deadline", title);
  out_.path(move_to({place, lanes_top_ - 90}) + line_to({place + 70, lanes_top_ - 60}) +
                line_to({place, lanes_top_ - 30}) + "Z",
            "deadline-flag", title);
  const Length width = text_width(label, bar_font);
  const bool right = place + 90 + width <= scale_.x1();
  const Length left = right ? place + 90 : place - 30 - width;
  if (left >= Margin::group_x && labels_.claim({left, lanes_top_ - 110, left + width, lanes_top_ - 10})) {
    out_.text({left, lanes_top_ - 30}, Anchor::start, "on-light", label, title);
  }
}

// One beyond the right edge: where it lies, not its line.
void Panel::point_to_deadline(std::int64_t at_ns, const std::string& label) {
  const std::string title = label + "\n" + at(at_ns);
  const Length tip = scale_.x1();
  const Length y = lanes_top_ - 60;
  const Length left = tip - 130 - text_width(label, bar_font);
  if (left < Margin::group_x || !labels_.claim({left, y - 50, tip, y + 50})) return;
  out_.text({left, y + 30}, Anchor::start, "on-light", label, title);
  out_.path(move_to({tip - 90, y}) + line_to({tip - 30, y}), "deadline-pointer", title);
  out_.path(move_to({tip - 60, y - 30}) + line_to({tip, y}) + line_to({tip - 60, y + 30}) + "Z",
            "deadline-flag", title);
}

}  // namespace pal::analyzer::chart
