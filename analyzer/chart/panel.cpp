#include "analyzer/chart/panel.hpp"

#include <algorithm>
#include <utility>

#include "analyzer/chart/chart.hpp"

namespace pal::analyzer::chart {

namespace {

constexpr Length group_x = Margin::group_x;
constexpr Length deadline_row = 240;
constexpr Length fold_edge = 40;
constexpr Length right_margin = 130;  // of the page, beyond panel_right

bool same_group(const Lane& a, const Lane& b) {
  return !a.device && !b.device && a.processor == b.processor;
}

}  // namespace

Panel::Panel(const std::vector<Layer>& layers, const TimeScale& scale, PanelStyle style,
             const Numbering& numbering, std::int64_t zero_ns, std::vector<Window> enlarged, Length top,
             SvgWriter& out)
    : layers_(layers),
      scale_(scale),
      style_(style),
      numbering_(numbering),
      zero_ns_(zero_ns),
      enlarged_(std::move(enlarged)),
      top_(top),
      out_(out) {
  place_rows();
  for (const TimeScale::Piece& piece : scale_.pieces()) {
    if (piece.folded) labels_.take({piece.x0, top_, piece.x1, bottom_});
  }
}

std::string Panel::at(std::int64_t ns) const {
  return duration_text(ns - zero_ns_);
}

void Panel::place_rows() {
  lanes_top_ = top_ + deadline_row;
  Length y = lanes_top_;
  const std::vector<Lane>& lanes = layers_.front().timeline->lanes;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    // A little air and, over several threads, room for what their processor does.
    if (i > 0 && !same_group(lanes[i - 1], lanes[i])) y += 40;
    const Length bar_top = y + style_.text_row();
    rows_.push_back({y, bar_top, bar_top + style_.bar_height()});
    y += style_.lane_height();
  }
  lanes_bottom_ = y + 30;
  y = lanes_bottom_;
  for (std::size_t i = 0; i < layers_.front().timeline->waveforms.size(); ++i) {
    waves_.push_back({y, y + 40, y + style_.wave_height() - 40});
    y += style_.wave_height();
  }
  y += 40;
  for (const Layer& layer : layers_) {
    if (layer.options->highlight) y += dimension_row;
  }
  if (!layers_.front().options->explanation.empty()) y += dimension_row;
  bottom_ = y;
}

Length Panel::draw() {
  out_.raw(style_.labelled ? "<g>\n" : "<g class=\"compact\">\n");
  for (const Layer& layer : layers_) find_crowds(layer);
  draw_bands();
  draw_grid();
  draw_names();
  for (const Layer& layer : layers_) {
    draw_gaps(layer);
    draw_bars(layer);
    draw_waves(layer);
  }
  for (const Layer& layer : layers_) draw_arrows(layer);
  for (const Layer& layer : layers_) draw_losses(layer);
  draw_folds();
  for (const Layer& layer : layers_) draw_missed_change(layer);
  draw_deadlines();
  for (const Layer& layer : layers_) keep_off_edges(layer);
  for (const Layer& layer : layers_) keep_off_arrows(layer);
  for (const Layer& layer : layers_) draw_marks(layer);
  for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer) label_bars(*layer);
  if (style_.labelled) {
    for (const Layer& layer : layers_) label_arrows(layer);
    for (const Layer& layer : layers_) label_gaps(layer);
  }
  draw_dimensions();
  draw_axis();
  out_.raw("</g>\n");
  return bottom_ + 220;
}

void Panel::draw_names() {
  const std::vector<Lane>& lanes = layers_.front().timeline->lanes;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const Lane& lane = lanes[i];
    const Row& row = rows_[i];
    const Length middle = (row.bar_top + row.bar_bottom) / 2;
    const std::string title = lane.device ? "device " + lane.name
                                          : "thread " + lane.name + " on processor " + lane.processor +
                                                ", priority " + std::to_string(lane.priority);
    const Length name_x = style_.margin.name_x;
    const Length room = style_.margin.left - (lane.device ? group_x : name_x) - 40;
    const bool fits = text_width(lane.name, 110) <= room;
    out_.text({lane.device ? group_x : name_x, middle + 38}, Anchor::start,
              std::string("name") + (lane.device ? " device" : "") + (fits ? "" : " long"),
              fitted(lane.name, fits ? 110 : 78, room), title);
    if (lane.device || (i > 0 && same_group(lanes[i - 1], lane))) continue;
    std::size_t last = i;
    while (last + 1 < lanes.size() && same_group(lane, lanes[last + 1])) ++last;
    const Length top = row.bar_top;
    const Length bottom = rows_[last].bar_bottom;
    out_.path(move_to({name_x - 50, top}) + line_to({name_x - 90, top}) + line_to({name_x - 90, bottom}) +
                  line_to({name_x - 50, bottom}),
              "bracket");
    const Length processor_room = name_x - 130 - group_x;
    const bool whole = text_width(lane.processor, 110, true) <= processor_room;
    out_.text({name_x - 130, (top + bottom) / 2 + 38}, Anchor::end, whole ? "processor" : "processor long",
              fitted(lane.processor, whole ? 110 : 90, processor_room, true), "processor " + lane.processor);
  }
  const std::vector<Waveform>& waves = layers_.front().timeline->waveforms;
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const Length room = style_.margin.left - group_x - 380;
    const bool whole = text_width(waves[i].name, 110) <= room;
    out_.text({group_x, (waves_[i].bar_top + waves_[i].bar_bottom) / 2 + 35}, Anchor::start,
              whole ? "name condition" : "name condition long", fitted(waves[i].name, whole ? 110 : 78, room),
              "condition " + waves[i].name);
  }
}

void Panel::draw_grid() {
  for (std::size_t i = 0; i < rows_.size(); i += 1) {
    const Length middle = (rows_[i].bar_top + rows_[i].bar_bottom) / 2;
    out_.line({scale_.x0(), middle}, {scale_.x1(), middle}, "guide");
  }
  for (const Tick& tick : ticks(scale_, zero_ns_).major) {
    const Length place = scale_.x(tick.at_ns);
    out_.line({place, lanes_top_}, {place, bottom_}, "grid");
  }
}

void Panel::draw_axis() {
  const Ticks marks = ticks(scale_, zero_ns_);
  for (const TimeScale::Piece& piece : scale_.pieces()) {
    if (!piece.folded) out_.line({piece.x0, bottom_}, {piece.x1, bottom_}, "axis");
  }
  for (const std::int64_t at : marks.minor)
    out_.line({scale_.x(at), bottom_}, {scale_.x(at), bottom_ + 30}, "axis");
  for (const Tick& tick : marks.major)
    out_.line({scale_.x(tick.at_ns), bottom_}, {scale_.x(tick.at_ns), bottom_ + 60}, "axis");
  draw_tick_labels(marks);
  out_.text({group_x, bottom_ + 170}, Anchor::start, "tick", "time in " + marks.unit);
  for (const Window& window : enlarged_) {
    out_.rect({scale_.x(window.from_ns), bottom_ - 25,
               std::max(scale_.x(window.to_ns), scale_.x(window.from_ns) + 20), bottom_ + 5},
              "enlarged", "enlarged below: " + at(window.from_ns) + " to " + at(window.to_ns));
  }
}

// First one for each stretch, so that none is without, then all others that have room.
void Panel::draw_tick_labels(const Ticks& marks) {
  Labels taken;
  const auto label = [&](const Tick& tick) {
    const Length half = text_width(tick.label, 100) / 2;
    // A label at the right edge stays on the page.
    const Length place = std::min(scale_.x(tick.at_ns), panel_right(layers_) + right_margin - half);
    if (taken.claim({place - half - 30, 0, place + half + 30, 1}))
      out_.text({place, bottom_ + 170}, Anchor::middle, "tick", tick.label);
  };
  const Tick* labelled = nullptr;
  for (const TimeScale::Piece& piece : scale_.pieces()) {
    const auto inside = [&](const Tick& tick) {
      return tick.at_ns >= piece.time.from_ns && tick.at_ns <= piece.time.to_ns;
    };
    const auto first = std::find_if(marks.major.begin(), marks.major.end(), inside);
    if (piece.folded || first == marks.major.end() || &*first == labelled) continue;
    labelled = &*first;
    label(*first);
  }
  for (const Tick& tick : marks.major) label(tick);
}

void Panel::draw_tear(Length place, const std::string& title) {
  const Length step = 60;
  Length side = 30;
  std::string data = move_to({place - side, lanes_top_ - 20});
  for (Length y = lanes_top_ - 20 + step; y <= bottom_ + 40; y += step) {
    data += line_to({place + side, y});
    side = -side;
  }
  out_.path(data, "tear", title);
}

// The time left out is written across the fold, so that it is not mistaken for a time of the axis.
void Panel::draw_fold(const TimeScale::Piece& piece) {
  const std::int64_t length = piece.time.to_ns - piece.time.from_ns;
  const std::string title =
      duration_text(length) + " left out, from " + at(piece.time.from_ns) + " to " + at(piece.time.to_ns);
  out_.rect({piece.x0 + fold_edge, lanes_top_ - 20, piece.x1 - fold_edge, bottom_ + 40}, "fold", title);
  draw_tear(piece.x0 + fold_edge, title);
  draw_tear(piece.x1 - fold_edge, title);
  // To a hundredth of a millisecond; the title is exact.
  const std::string figure = duration_text(length < 10'000 ? length : (length + 5'000) / 10'000 * 10'000);
  const Point middle{(piece.x0 + piece.x1) / 2 + 28, (lanes_top_ + lanes_bottom_) / 2};
  for (const std::string& text : {figure + " left out", figure}) {
    if (text_width(text, 80) + 40 > bottom_ - lanes_top_) continue;
    out_.upright(middle, "cut", text, title);
    break;
  }
}

void Panel::draw_folds() {
  for (const TimeScale::Piece& piece : scale_.pieces()) {
    if (piece.folded) draw_fold(piece);
  }
  const Layer& first = layers_.front();
  const std::int64_t run_from = first.shift_ns;
  const std::int64_t run_to = first.timeline->end_ns + first.shift_ns;
  if (scale_.from_ns() > run_from)
    draw_tear(scale_.x0(), duration_text(scale_.from_ns() - run_from) + " before this are left out");
  if (scale_.to_ns() < run_to)
    draw_tear(scale_.x1(), duration_text(run_to - scale_.to_ns()) + " after this are left out");
}

}  // namespace pal::analyzer::chart
