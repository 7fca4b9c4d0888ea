#include "analyzer/chart/sequence.hpp"

#include <algorithm>

#include "analyzer/chart/svg_writer.hpp"
#include "pal/support/xml.hpp"

namespace pal::analyzer::chart {

namespace {

constexpr Length sequence_width = 9400;
constexpr Length margin = 300;
constexpr Length number_width = 350;
constexpr Length place_width = 1500;
constexpr Length sequence_row = 250;
constexpr Length first_row = 1250;
constexpr Length text_size = 90;

constexpr const char* style_sheet = R"svg(<style>
text { font-family: "DejaVu Sans", Verdana, sans-serif; font-size: 90px; fill: #000 }
.mid { text-anchor: middle } .end { text-anchor: end }
.title { font-size: 150px; font-weight: bold } .subtitle { font-size: 105px }
.lane { font-size: 115px; font-weight: bold } .lane.device { font-style: italic } .kind { font-size: 80px; fill: #333 }
.head { fill: #fff; stroke: #000; stroke-width: 10px } .head.device { stroke-dasharray: 30 20 }
.life { stroke: #777; stroke-width: 8px } .life.device { stroke-dasharray: 30 20 }
.message { stroke: #000; stroke-width: 10px; fill: none; marker-end: url(#tip) }
.message.lost { stroke-dasharray: 35 20; marker-end: url(#lost) }
.label { paint-order: stroke; stroke: #fff; stroke-width: 24px }
.note { fill: #fff; stroke: #000; stroke-width: 6px }
.stop { fill: #000 } .stop-text { fill: #fff; font-weight: bold } .stop-place { fill: #fff; font-size: 80px }
.end-mark { stroke: #000; stroke-width: 30px }
.place { font-size: 80px; fill: #333 } .row { fill: #555; font-size: 80px } .paper { fill: #fff }
.ruler { stroke: #eee; stroke-width: 5px }
</style>
<defs>
<marker id="tip" markerUnits="userSpaceOnUse" markerWidth="90" markerHeight="70" refX="90" refY="35" orient="auto"><path d="M0 0L90 35L0 70Z"/></marker>
<marker id="lost" markerUnits="userSpaceOnUse" markerWidth="90" markerHeight="90" refX="45" refY="45" orient="auto"><path d="M10 10L80 80M80 10L10 80" stroke="#000" stroke-width="16"/></marker>
</defs>
)svg";

/// Words on as few lines as fit the width.
std::vector<std::string> wrapped(const std::string& text, Length width) {
  std::vector<std::string> lines(1);
  std::size_t at = 0;
  while (at < text.size()) {
    const auto end = std::min(text.find(' ', at), text.size());
    const auto word = text.substr(at, end - at);
    const auto longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || text_width(longer, text_size, true) <= width) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
    at = end + 1;
  }
  return lines;
}

class Drawing {
 public:
  explicit Drawing(const SequenceChart& chart) : chart_(chart) {
    const auto lanes = static_cast<Length>(std::max<std::size_t>(chart.lanes.size(), 1));
    spacing_ = (sequence_width - 2 * margin - number_width - place_width) / lanes;
    for (const auto& stop : chart.stops) {
      stop_lines_ = std::max(stop_lines_, wrapped(stop.text, spacing_ - 160).size());
    }
    bottom_ = y(chart.places.size()) + (chart.stops.empty() ? 0 : stop_height() + 100);
  }

  std::string draw() {
    const Length height = bottom_ + 150;
    head(height);
    lanes();
    for (std::size_t row = 0; row < chart_.places.size(); ++row) rule(row);
    for (const auto& message : chart_.messages) draw(message);
    for (const auto& note : chart_.notes) draw(note);
    for (const auto& stop : chart_.stops) draw(stop);
    out_.raw("</svg>\n");
    return out_.str();
  }

 private:
  Length x(std::size_t lane) const {
    return margin + number_width + spacing_ * static_cast<Length>(lane) + spacing_ / 2;
  }
  static Length y(std::size_t row) { return first_row + sequence_row * static_cast<Length>(row); }
  Length stop_height() const { return 130 * static_cast<Length>(stop_lines_) + 200; }

  void head(Length height) {
    const auto size = [](Length value) { return std::to_string(value); };
    out_.raw(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
        size(sequence_width / 10) + "\" height=\"" + size(height / 10) + "\" viewBox=\"0 0 " +
        size(sequence_width) + " " + size(height) + "\" role=\"img\">\n<title>" + xml_escaped(chart_.title) +
        "</title>\n<desc>" + xml_escaped(chart_.subtitle) + "</desc>\n");
    out_.raw(style_sheet);
    out_.rect({0, 0, sequence_width, height}, "paper");
    out_.text({margin, 280}, Anchor::start, "title", fitted(chart_.title, 150, sequence_width - 2 * margin),
              chart_.title);
    out_.text({margin, 450}, Anchor::start, "subtitle",
              fitted(chart_.subtitle, 105, sequence_width - 2 * margin), chart_.subtitle);
  }

  void lanes() {
    for (std::size_t i = 0; i < chart_.lanes.size(); ++i) {
      const auto& lane = chart_.lanes[i];
      const std::string of = lane.device ? " device" : "";
      out_.line({x(i), 960}, {x(i), bottom_}, "life" + of);
      out_.rect({x(i) - spacing_ / 2 + 40, 620, x(i) + spacing_ / 2 - 40, 960}, "head" + of,
                lane.kind + " " + lane.name);
      out_.text({x(i), 770}, Anchor::middle, "lane" + of, fitted(lane.name, 115, spacing_ - 120));
      out_.text({x(i), 900}, Anchor::middle, "kind", fitted(lane.kind, 80, spacing_ - 100));
    }
  }

  void rule(std::size_t row) {
    out_.line({margin + number_width, y(row) + 90}, {sequence_width - margin, y(row) + 90}, "ruler");
    out_.text({margin + 200, y(row) + 30}, Anchor::end, "row", std::to_string(row + 1));
    out_.text({sequence_width - margin, y(row) + 30}, Anchor::end, "place",
              fitted(chart_.places[row], 80, place_width - 80), chart_.places[row]);
  }

  void draw(const SequenceMessage& message) {
    const Length from = x(message.from_lane);
    const bool right = x(message.to_lane) >= from;
    const std::string title = chart_.lanes[message.from_lane].name + " sends " + message.label + " to " +
                              chart_.lanes[message.to_lane].name +
                              (message.to_row ? "" : ", which never takes it");
    if (message.to_row) {
      out_.line({from, y(message.from_row)}, {x(message.to_lane), y(*message.to_row)}, "message", title);
    } else {
      const Length reach = from + (x(message.to_lane) - from) * 8 / 10;
      out_.line({from, y(message.from_row)}, {reach, y(message.from_row) + 60}, "message lost", title);
    }
    out_.text({from + (right ? 70 : -70), y(message.from_row) - 35}, right ? Anchor::start : Anchor::end,
              "label", message.label, title);
  }

  void draw(const SequenceNote& note) {
    const std::string text = fitted(note.text, text_size, std::max(spacing_ * 2 - 200, Length{1400}));
    Length half = text_width(text, text_size) / 2 + 60;
    Length middle = x(note.lane);
    middle = std::max(middle, margin + number_width + half);
    middle = std::min(middle, sequence_width - margin - place_width - half);
    out_.rect({middle - half, y(note.row) - 90, middle + half, y(note.row) + 80}, "note",
              chart_.lanes[note.lane].name + " " + note.text);
    out_.text({middle, y(note.row) + 30}, Anchor::middle, "in-note", text);
  }

  void draw(const SequenceStop& stop) {
    const Length top = y(chart_.places.size()) - 40;
    const Length middle = x(stop.lane);
    const std::string title = chart_.lanes[stop.lane].name + " " + stop.text + " for ever";
    out_.rect({middle - spacing_ / 2 + 40, top, middle + spacing_ / 2 - 40, top + stop_height()}, "stop",
              title);
    Length at = top + 140;
    for (const auto& line : wrapped(stop.text, spacing_ - 160)) {
      out_.text({middle, at}, Anchor::middle, "stop-text", fitted(line, text_size, spacing_ - 100));
      at += 130;
    }
    out_.text({middle, at}, Anchor::middle, "stop-place", fitted(stop.place, 80, spacing_ - 100), stop.place);
    out_.line({middle - 120, top + stop_height() + 40}, {middle + 120, top + stop_height() + 40}, "end-mark",
              title);
  }

  const SequenceChart& chart_;
  SvgWriter out_;
  Length spacing_ = 0;
  std::size_t stop_lines_ = 1;
  Length bottom_ = 0;
};

}  // namespace

std::string sequence_svg(const SequenceChart& chart) {
  return Drawing(chart).draw();
}

}  // namespace pal::analyzer::chart
