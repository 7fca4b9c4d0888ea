// One coordinate system of a chart: lanes, waveforms and dimension lines over one time scale.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analyzer/chart/labels.hpp"
#include "analyzer/chart/layer.hpp"
#include "analyzer/chart/margin.hpp"
#include "analyzer/chart/numbering.hpp"
#include "analyzer/chart/svg_writer.hpp"
#include "analyzer/chart/time_scale.hpp"

namespace pal::analyzer::chart {

constexpr Length fold_width = 300;
constexpr Length dimension_row = 190;  // height of a row of dimension lines

/// `labelled`: rows with room for labels above the bars; otherwise rows are low and only what fits into a bar
/// is written.
struct PanelStyle {
  bool labelled = true;
  bool overlay = false;  // two runs share a lane
  Margin margin;
  /// Bars no wider than this, and no farther apart, are drawn as one block; 0: each by itself.
  Length crowd = 0;
  Length lane_height() const { return bar_height() + (labelled ? 150 : 60); }
  Length bar_height() const { return labelled ? (overlay ? 220 : 150) : (overlay ? 140 : 110); }
  Length wave_height() const { return labelled ? 200 : 150; }
  Length text_row() const { return labelled ? 120 : 30; }
};

class Panel {
 public:
  /// The first layer's lanes set the rows. `zero_ns` is where the axis counts from; `enlarged` are windows
  /// that another panel shows larger. Everything passed by reference outlives the panel.
  Panel(const std::vector<Layer>& layers, const TimeScale& scale, PanelStyle style,
        const Numbering& numbering, std::int64_t zero_ns, std::vector<Window> enlarged, Length top,
        SvgWriter& out);

  /// Draws everything; returns where the panel ends.
  Length draw();

 private:
  struct Row {
    Length top = 0;
    Length bar_top = 0;
    Length bar_bottom = 0;
  };

  /// Bars next to each other that are too narrow even for their numbers.
  struct Cluster {
    Length x0 = 0;
    Length x1 = 0;
    std::vector<int> numbers;
  };

  /// Bars of a lane that are drawn as one block.
  struct Crowd {
    std::size_t first = 0;
    std::size_t bars = 0;
    std::int64_t from_ns = 0;
    std::int64_t to_ns = 0;
  };

  // panel_crowds.cpp: what is drawn as one block
  void find_crowds(const Layer& layer);
  const Crowd* crowd_at(const Layer& layer, std::size_t lane, std::int64_t from_ns, std::int64_t to_ns) const;
  bool has_crowds(const Layer& layer) const;
  void draw_crowd(const Layer& layer, std::size_t lane, const Crowd& crowd);
  static bool is_edge(const Layer& layer, std::int64_t ns);

  // panel.cpp: the frame
  void place_rows();
  void draw_names();
  void draw_grid();
  void draw_axis();
  void draw_folds();
  void draw_fold(const TimeScale::Piece& piece);
  void draw_tear(Length place, const std::string& title);
  void draw_tick_labels(const Ticks& marks);

  // panel_lanes.cpp: what the lanes and the waveforms hold
  void draw_bars(const Layer& layer);
  void draw_waves(const Layer& layer);
  void label_bars(const Layer& layer);
  void label_wide_bar(const Layer& layer, const Lane& lane, const Bar& bar, const Box& box);
  bool label_narrow_bar(const Layer& layer, const Lane& lane, const Bar& bar, const Box& box, int number);
  void label_backdrop(int number, const Box& box);
  void label_cluster(const Cluster& cluster, const Row& row);
  Box bar_box(const Layer& layer, std::size_t lane, std::int64_t from_ns, std::int64_t to_ns) const;
  std::string bar_title(const Layer& layer, const Lane& lane, const Bar& bar) const;

  // panel_gaps.cpp: when threads do not run
  void draw_gaps(const Layer& layer);
  void label_gaps(const Layer& layer);
  void label_gap(const Layer& layer, const Gap& gap, const Row& row);
  std::vector<Length> gap_label_places(const Layer& layer, Length left, Length right) const;
  void keep_off_edges(const Layer& layer);

  // panel_losses.cpp: what no thread took
  void draw_losses(const Layer& layer);

  // panel_arrows.cpp: messages and marks
  void draw_arrows(const Layer& layer);
  void label_arrows(const Layer& layer);
  void draw_marks(const Layer& layer);
  void draw_promise(const Layer& layer, const Mark& mark, Length place);
  std::vector<Point> label_places(Point from, Point to) const;
  void label_mark(const std::string& text, Length place);
  void keep_off_arrows(const Layer& layer);
  bool arrow_ends(const Layer& layer, const Arrow& arrow, Point& from, Point& to) const;

  // dimensions.cpp: the interval that the chart is about
  void draw_bands();
  void draw_dimensions();
  void draw_edges(const Layer& layer, const Highlight& highlight, Length y);
  void draw_dimension(const Layer& layer, const Highlight& highlight, Length y);
  void draw_segments(const Layer& layer, Length y);
  void draw_missed_change(const Layer& layer);
  void draw_deadlines();
  void draw_deadline(std::int64_t at_ns, const std::string& label);
  void point_to_deadline(std::int64_t at_ns, const std::string& label);

  std::string at(std::int64_t ns) const;
  Length x(const Layer& layer, std::int64_t ns) const { return scale_.x(ns + layer.shift_ns); }
  bool touches(const Layer& layer, std::int64_t from_ns, std::int64_t to_ns) const {
    // What only touches a window at its edge is not seen in it.
    const std::int64_t edge = to_ns - from_ns >= 2 ? 1 : 0;
    return scale_.touches(from_ns + layer.shift_ns + edge, to_ns + layer.shift_ns - edge);
  }

  const std::vector<Layer>& layers_;
  const TimeScale& scale_;
  PanelStyle style_;
  const Numbering& numbering_;
  std::int64_t zero_ns_;
  std::vector<Window> enlarged_;
  Length top_;
  SvgWriter& out_;
  Labels labels_;
  std::vector<Row> rows_;
  std::vector<Row> waves_;
  std::map<const Layer*, std::vector<std::vector<Crowd>>> crowds_;  // by lane, in order of time
  Length lanes_top_ = 0;
  Length lanes_bottom_ = 0;
  Length bottom_ = 0;  // of all but the axis
};

/// The sign of a change that a sample has just missed; its tip is at `at`.
std::string missed_change_sign(Point at);

/// "a", "b", …, "z", "aa", …: the name of an explanation's part.
std::string segment_letter(std::size_t index);

}  // namespace pal::analyzer::chart
