#include "analyzer/chart/legend.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/panel.hpp"
#include "analyzer/chart/promises.hpp"

namespace pal::analyzer::chart {

namespace {

constexpr Length legend_edge = 40;
constexpr Length row_height = 125;
constexpr Length font = 90;

std::string drawn_figure(const Layer& layer, std::int64_t ns) {
  return layer.timeline->origin == "measured" ? rounded_duration_text(ns) : duration_text(ns);
}

// Where the texts of an explanation begin; each depth of its tree stands further to the right.
constexpr Length explained_x = 840;
constexpr Length depth_indent = 500;
constexpr Length narrow_indent = 200;

/// The texts of an explanation's parts.
class Explanation {
 public:
  explicit Explanation(const Layer& layer) {
    for (const Segment& segment : layer.options->explanation) {
      const std::string who = segment.actor.empty() ? "" : segment.actor + ": ";
      texts_.push_back(who + segment.text + (segment.place.empty() ? "" : " (" + segment.place + ")"));
      widest_ = std::max(widest_, text_width(texts_.back(), font));
      tree_ = tree_ || segment.depth > 0;
    }
  }

  const std::string& text(std::size_t part) const { return texts_[part]; }
  /// Two columns read downwards, if every part fits into half of the page.
  bool halves(Length full_width) const {
    return texts_.size() > 6 && !tree_ && explained_x + widest_ + 40 <= full_width / 2;
  }

 private:
  std::vector<std::string> texts_;
  Length widest_ = 0;
  bool tree_ = false;
};

}  // namespace

Length draw_explanation(const std::vector<Layer>& layers, Length top, SvgWriter& out) {
  const Layer& layer = layers.front();
  const Length full_width = panel_right(layers) - legend_edge;
  const std::vector<Segment>& segments = layer.options->explanation;
  if (segments.empty()) return top;
  std::string heading = "How this comes about";
  if (layer.options->highlight) {
    heading = "How the " +
              drawn_figure(layer, layer.options->highlight->to_ns - layer.options->highlight->from_ns) +
              " come about";
  }
  top = draw_panel_heading(heading, top, out) + 60;
  const Explanation parts(layer);
  const bool halves = parts.halves(full_width);
  const std::size_t rows = halves ? (segments.size() + 1) / 2 : segments.size();
  const Length room = (halves ? full_width / 2 : full_width) - explained_x;
  Length y = top;
  Length lowest = top;
  std::size_t letter = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (i == rows) y = top;
    const Length x = legend_edge + (i < rows ? 0 : full_width / 2);
    const Length indent = segments[i].depth * (layer.options->narrow ? narrow_indent : depth_indent);
    y += row_height;
    if (segments[i].depth == 0) out.text({x, y}, Anchor::start, "key strong", segment_letter(letter++));
    out.text({x + explained_x - 80 + indent, y}, Anchor::end, "key",
             drawn_figure(layer, segments[i].to_ns - segments[i].from_ns));
    const std::vector<std::string> lines = wrapped(parts.text(i), font, room - indent);
    for (std::size_t line = 0; line < lines.size(); ++line) {
      if (line > 0) y += row_height;
      out.text({x + explained_x + indent, y}, Anchor::start, "key", lines[line]);
    }
    lowest = std::max(lowest, y);
  }
  return lowest + 40;
}

Length draw_statement_key(const Numbering& numbering, Length right, Length top, SvgWriter& out) {
  const Length full_width = right - legend_edge;
  const auto& entries = numbering.entries();
  if (entries.empty()) return top;
  top = draw_panel_heading("Numbered statements", top, out) + 60;
  Length widest = 0;
  Length lane_width = 0;
  for (const Numbering::Entry& entry : entries) {
    widest = std::max(widest, text_width(entry.text, font));
    lane_width = std::max(lane_width, text_width(entry.lane, font, true));
  }
  widest = std::min(widest, full_width - lane_width - 420);
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

Length draw_sign_key(const std::vector<Layer>& layers, Length top, SvgWriter& out) {
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
  const bool fails = std::any_of(layers.begin(), layers.end(), [](const Layer& layer) {
    return layer.options->highlight && layer.options->highlight->fails;
  });
  const bool overlay = layers.size() > 1;
  sign(overlay, "proved run", bar("bar computation backdrop"));
  sign(overlay, "measured run", [&out](Length x, Length y) {
    out.rect({x, y, x + 300, y + 50}, "bar computation");
  });
  sign(out.has_drawn("bar computation"), "activity", bar("bar computation"));
  sign(out.has_drawn("bar message"), "send, receive", bar("bar message"));
  sign(out.has_drawn("bar conditional"), "set, read or test of conditions", bar("bar conditional"));
  sign(out.has_drawn("bar serving"), "device busy", bar("bar serving"));
  sign(out.has_drawn("crowd"), "many actions, without their messages; of events near one another the first",
       bar("crowd"));
  sign(out.has_drawn("wait"), "waits", stroke("wait"));
  sign(out.has_drawn("ready"), "ready, but the processor is taken", bar("ready"));
  sign(out.has_drawn("event"), "device event", [&out](Length x, Length y) {
    out.path(move_to({x + 105, y - 50}) + line_to({x + 195, y - 50}) + line_to({x + 150, y + 50}) + "Z",
             "event");
  });
  sign(out.has_drawn("overrun"), "event lost", crossed("overrun"));
  sign(out.has_drawn("loss"), "lost: not taken", [&out](Length x, Length y) {
    out.rect({x, y - 50, x + 300, y + 50}, "bar serving");
    out.path(
        move_to({x, y - 50}) + line_to({x + 300, y + 50}) + move_to({x, y + 50}) + line_to({x + 300, y - 50}),
        "loss");
  });
  sign(out.has_drawn("missed"), "change that is just missed", [&out](Length x, Length y) {
    out.path(missed_change_sign({x + 150, y + 50}), "missed read");
  });
  sign(out.has_drawn("broken"), "promise broken", [&out](Length x, Length y) {
    draw_promise_sign({x + 150, y}, 1, "broken", "", out);
  });
  sign(out.has_drawn("arrow"), "message", stroke("arrow"));
  sign(out.has_drawn("arrow dropped"), "message withdrawn", stroke("arrow dropped"));
  sign(out.has_drawn("gave-up"), "gives up waiting", crossed("gave-up"));
  sign(out.has_drawn("set"), "condition set", spot("set"));
  sign(out.has_drawn("read"), "condition read", spot("read"));
  sign(out.has_drawn("deadline"), "deadline", [&out](Length x, Length y) {
    out.line({x + 120, y - 60}, {x + 120, y + 60}, "deadline");
    out.path(move_to({x + 120, y - 60}) + line_to({x + 190, y - 30}) + line_to({x + 120, y}) + "Z",
             "deadline-flag");
  });
  sign(out.has_drawn("band"), fails ? "interval that is too long" : "interval of the requirement",
       [&out, fails](Length x, Length y) {
         const std::string verdict = fails ? "fails" : "holds";
         out.rect({x, y - 50, x + 300, y + 50}, "band " + verdict);
         out.line({x, y}, {x + 300, y}, "dimension measure " + verdict);
       });
  sign(out.has_drawn("tear"), "time left out", [&out](Length x, Length y) {
    out.path(move_to({x + 120, y - 60}) + line_to({x + 180, y - 20}) + line_to({x + 120, y + 20}) +
                 line_to({x + 180, y + 60}),
             "tear");
  });

  top = draw_panel_heading("Key", top, out) + 80;
  Length x = legend_edge;
  Length y = top + 80;
  for (const Sign& it : signs) {
    const Length width = 360 + text_width(it.text, font) + 220;
    if (x + width > panel_right(layers) && x > legend_edge) {
      x = legend_edge;
      y += row_height + 25;
    }
    it.draw(x, y);
    out.text({x + 360, y + 32}, Anchor::start, "key", it.text);
    x += width;
  }
  return y + row_height;
}

}  // namespace pal::analyzer::chart
