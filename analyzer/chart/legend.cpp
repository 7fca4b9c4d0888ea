#include "analyzer/chart/legend.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/panel.hpp"

namespace pal::chart {

namespace {

constexpr Length legend_edge = 40;
constexpr Length row_height = 125;
constexpr Length font = 90;
constexpr Length full_width = panel_right - legend_edge;

std::string drawn_figure(const Layer& layer, std::int64_t ns) {
  return layer.timeline->origin == "measured" ? rounded_duration_text(ns) : duration_text(ns);
}

bool any_gap(const std::vector<Layer>& layers, GapKind kind) {
  for (const Layer& layer : layers) {
    for (const Lane& lane : layer.timeline->lanes) {
      if (std::any_of(lane.gaps.begin(), lane.gaps.end(), [&](const Gap& gap) { return gap.kind == kind; }))
        return true;
    }
  }
  return false;
}

bool any_bar(const std::vector<Layer>& layers, BarKind kind) {
  for (const Layer& layer : layers) {
    for (const Lane& lane : layer.timeline->lanes) {
      if (std::any_of(lane.bars.begin(), lane.bars.end(), [&](const Bar& bar) { return bar.kind == kind; }))
        return true;
    }
  }
  return false;
}

bool any_mark(const std::vector<Layer>& layers, MarkKind kind) {
  for (const Layer& layer : layers) {
    const auto& marks = layer.timeline->marks;
    if (std::any_of(marks.begin(), marks.end(), [&](const Mark& mark) { return mark.kind == kind; }))
      return true;
  }
  return false;
}

bool any_arrow(const std::vector<Layer>& layers, Fate fate) {
  for (const Layer& layer : layers) {
    const auto& arrows = layer.timeline->arrows;
    if (std::any_of(arrows.begin(), arrows.end(), [&](const Arrow& arrow) { return arrow.fate == fate; }))
      return true;
  }
  return false;
}

}  // namespace

Length draw_explanation(const Layer& layer, Length top, SvgWriter& out) {
  const std::vector<Segment>& segments = layer.options->explanation;
  if (segments.empty()) return top;
  std::string heading = "How this comes about";
  if (layer.options->highlight) {
    heading = "How the " +
              drawn_figure(layer, layer.options->highlight->to_ns - layer.options->highlight->from_ns) +
              " come about";
  }
  top = draw_panel_heading(heading, top, out) + 60;
  // Two columns read downwards.
  const std::size_t rows = segments.size() > 6 ? (segments.size() + 1) / 2 : segments.size();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    const Length x = legend_edge + static_cast<Length>(i / rows) * full_width / 2;
    const Length y = top + static_cast<Length>(i % rows + 1) * row_height;
    out.text({x, y}, Anchor::start, "key strong", segment_letter(i));
    out.text({x + 720, y}, Anchor::end, "key", drawn_figure(layer, segment.to_ns - segment.from_ns));
    const std::string text = segment.actor.empty() ? segment.text : segment.actor + ": " + segment.text;
    const std::string place = segment.place.empty() ? "" : " (" + segment.place + ")";
    const Length room = (rows < segments.size() ? full_width / 2 : full_width) - 830;
    // Where it is written stays to be read; what is said there gets the rest.
    const std::string said = fitted(text, font, room - text_width(place, font));
    const std::string shown = said.empty() ? fitted(text + place, font, room) : said + place;
    out.text({x + 800, y}, Anchor::start, "key", shown, text + place);
  }
  return top + static_cast<Length>(rows) * row_height + 40;
}

Length draw_statement_key(const Numbering& numbering, Length top, SvgWriter& out) {
  const auto& entries = numbering.entries();
  if (entries.empty()) return top;
  top = draw_panel_heading("Numbered statements", top, out) + 60;
  Length widest = 0;
  Length lane_width = 0;
  for (const Numbering::Entry& entry : entries) {
    widest = std::max(widest, text_width(entry.text, font));
    lane_width = std::max(lane_width, text_width(entry.lane, font, true));
  }
  widest = std::min(widest, full_width / 2 - lane_width - 400);
  const Length column = lane_width + widest + 420;
  const auto columns = static_cast<std::size_t>(std::max<Length>(1, full_width / column));
  const std::size_t rows = (entries.size() + columns - 1) / columns;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Numbering::Entry& entry = entries[i];
    const Length x = legend_edge + static_cast<Length>(i / rows) * column;
    const Length y = top + static_cast<Length>(i % rows + 1) * row_height;
    // The lane's name once, where its statements begin.
    if (i % rows == 0 || entries[i - 1].lane != entry.lane)
      out.text({x, y}, Anchor::start, "key strong", entry.lane);
    out.text({x + lane_width + 220, y}, Anchor::end, "key number", std::to_string(entry.number));
    out.text({x + lane_width + 270, y}, Anchor::start, "key", fitted(entry.text, font, widest), entry.text);
  }
  return top + static_cast<Length>(rows) * row_height + 40;
}

Length draw_sign_key(const std::vector<Layer>& layers, bool folded, Length top, SvgWriter& out) {
  struct Sign {
    std::function<void(Length, Length)> draw;  // at x, around y, 300 wide
    std::string text;
  };
  std::vector<Sign> signs;
  const auto sign = [&](bool used, const std::string& text, std::function<void(Length, Length)> draw) {
    if (used) signs.push_back({std::move(draw), text});
  };
  const auto bar = [&](const char* style) {
    return [&out, style](Length x, Length y) { out.rect({x, y - 50, x + 300, y + 50}, style); };
  };
  const auto stroke = [&](const char* style) {
    return [&out, style](Length x, Length y) { out.line({x, y}, {x + 300, y}, style); };
  };
  const auto crossed = [&out](const char* style) {
    return [&out, style](Length x, Length y) {
      out.path(move_to({x + 115, y - 35}) + line_to({x + 185, y + 35}) + move_to({x + 115, y + 35}) +
                   line_to({x + 185, y - 35}),
               style);
    };
  };
  const auto spot = [&out](const char* style) {
    return [&out, style](Length x, Length y) { out.rect({x + 122, y - 28, x + 178, y + 28}, style); };
  };
  bool waves = false;
  bool highlighted = false;
  bool limited = false;
  bool fails = false;
  for (const Layer& layer : layers) {
    waves = waves || !layer.timeline->waveforms.empty();
    highlighted = highlighted || layer.options->highlight.has_value();
    limited = limited || !layer.options->deadlines.empty() ||
              (layer.options->highlight && layer.options->highlight->limit_ns >= 0);
    fails = fails || (layer.options->highlight && layer.options->highlight->fails);
  }
  const bool overlay = layers.size() > 1;
  sign(overlay, "proved run", bar("bar computation backdrop"));
  sign(overlay, "measured run", [&out](Length x, Length y) {
    out.rect({x, y, x + 300, y + 50}, "bar computation");
  });
  sign(any_bar(layers, BarKind::computation), "activity", bar("bar computation"));
  sign(any_bar(layers, BarKind::message), "send, receive", bar("bar message"));
  sign(any_bar(layers, BarKind::condition), "set, read or test of conditions", bar("bar conditional"));
  sign(any_bar(layers, BarKind::serving), "device busy", bar("bar serving"));
  sign(any_gap(layers, GapKind::waiting), "waits", stroke("wait"));
  sign(any_gap(layers, GapKind::ready), "ready, but the processor is taken", bar("ready"));
  sign(any_mark(layers, MarkKind::event), "device event", [&out](Length x, Length y) {
    out.path(move_to({x + 105, y - 50}) + line_to({x + 195, y - 50}) + line_to({x + 150, y + 50}) + "Z",
             "event");
  });
  sign(any_mark(layers, MarkKind::overrun), "event lost", crossed("overrun"));
  sign(any_arrow(layers, Fate::taken), "message", stroke("arrow"));
  sign(any_arrow(layers, Fate::dropped), "message withdrawn", stroke("arrow dropped"));
  sign(any_mark(layers, MarkKind::gave_up), "gives up waiting", crossed("gave-up"));
  sign(waves, "condition set", spot("set"));
  sign(waves, "condition read", spot("read"));
  sign(limited, "deadline", [&out](Length x, Length y) {
    out.line({x + 120, y - 60}, {x + 120, y + 60}, "deadline");
    out.path(move_to({x + 120, y - 60}) + line_to({x + 190, y - 30}) + line_to({x + 120, y}) + "Z",
             "deadline-flag");
  });
  sign(highlighted, fails ? "interval that is too long" : "interval of the requirement",
       [&out, fails](Length x, Length y) {
         const std::string verdict = fails ? "fails" : "holds";
         out.rect({x, y - 50, x + 300, y + 50}, "band " + verdict);
         out.line({x, y}, {x + 300, y}, "dimension measure " + verdict);
       });
  sign(folded, "time left out", [&out](Length x, Length y) {
    out.path(move_to({x + 120, y - 60}) + line_to({x + 180, y - 20}) + line_to({x + 120, y + 20}) +
                 line_to({x + 180, y + 60}),
             "tear");
  });

  top = draw_panel_heading("Key", top, out) + 80;
  Length x = legend_edge;
  Length y = top + 80;
  for (const Sign& it : signs) {
    const Length width = 360 + text_width(it.text, font) + 220;
    if (x + width > panel_right && x > legend_edge) {
      x = legend_edge;
      y += row_height + 25;
    }
    it.draw(x, y);
    out.text({x + 360, y + 32}, Anchor::start, "key", it.text);
    x += width;
  }
  return y + row_height;
}

}  // namespace pal::chart
