// Slack over the values of one figure.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "pal/support/duration_text.hpp"
#include "study/cells.hpp"
#include "study/plot_page.hpp"
#include "study/plots.hpp"

namespace pal::study {
namespace {

using analyzer::chart::Anchor;
using analyzer::chart::SvgWriter;
using analyzer::chart::text_width;
using Measure = analyzer::Requirement::Measure;

constexpr Length plot_width = 9000, plot_height = 5200;
constexpr std::int64_t no_slack = std::numeric_limits<std::int64_t>::max();

/// One skill at one value.
struct Spot {
  std::int64_t least = no_slack;
  Outcome outcome = Outcome::holds;  // of what has no slack to show
};

/// 1, 2 or 5 times a power of ten, so that about five of them make `span`.
std::int64_t nice_step(std::int64_t span) {
  std::int64_t step = 1;
  while (step <= span / 10) step *= 10;
  if (span / step > 12) step *= 5;
  if (span / step > 6) step *= 2;
  return step;
}

class Plot {
 public:
  Plot(const Table& table, std::size_t figure)
      : table_(table),
        figure_(table.study.figures[figure]),
        spots_(table.pairs.size(), std::vector<Spot>(figure_.choices.size())) {
    std::vector<std::size_t> choices;
    std::uint32_t point = 0;
    for (const Row& row : table.rows) {
      if (choices.empty() || row.point != point) choices = choices_at(table.study, row.point);
      point = row.point;
      Spot& spot = spots_[row.pair][choices[figure]];
      const bool time = row.measure != Measure::load && row.measure != Measure::loss;
      if (time && slack(row)) spot.least = std::min(spot.least, *slack(row));
      // A failure with a bound stands below the line of 0, for all to see.
      const bool shown = time && slack(row) && (row.outcome == Outcome::holds || *slack(row) < 0);
      if (!shown) spot.outcome = worse(spot.outcome, row.outcome);
    }
    for (const auto& line : spots_) {
      for (const Spot& spot : line) {
        if (spot.least == no_slack || spot.outcome != Outcome::holds) continue;  // not drawn
        low_ = std::min(low_, spot.least);
        high_ = std::max(high_, spot.least);
      }
    }
    step_ = nice_step(std::max<std::int64_t>(high_ - low_, 1));
    low_ = (low_ / step_ - (low_ % step_ < 0 ? 1 : 0)) * step_;
    high_ = (high_ / step_ + (high_ % step_ > 0 || high_ == 0 ? 1 : 0)) * step_;
  }

  std::string draw() {
    left_ = margin + 300;
    for (std::int64_t at = low_; at <= high_; at += step_)
      left_ = std::max(left_, margin + 450 + text_width(amount(at), label_font));
    bottom_ = margin + 150 + 250 + plot_height;
    out_.text({margin, margin + 150}, Anchor::start, "title", table_.study.title);
    draw_axes();
    for (std::size_t i = 0; i < spots_.size(); ++i) draw_line(i);
    draw_legend();
    const Length width =
        std::max(legend_end_, margin + text_width(table_.study.title, title_font, true)) + margin;
    return page(width, std::max(bottom_ + 900, legend_bottom_ + margin), out_.str());
  }

 private:
  Length x(std::size_t value) const {
    const auto parts = static_cast<Length>(figure_.choices.size());
    return left_ + plot_width * (2 * static_cast<Length>(value) + 1) / (2 * parts);
  }
  Length y(std::int64_t value) const {
    // In floating point: the product of two whole numbers might not fit.
    const double part = static_cast<double>(value - low_) / static_cast<double>(high_ - low_);
    return bottom_ - static_cast<Length>(std::lround(part * static_cast<double>(plot_height)));
  }
  static std::string amount(std::int64_t value) {
    return (value < 0 ? "-" : "") + to_text(Duration(std::abs(value)));
  }
  std::string colour(std::size_t pair) const {
    return " c" + std::to_string(pair % 8) + " d" + std::to_string(pair / 8 % 4);
  }

  void draw_axes() {
    if (low_ < 0) out_.rect({left_, y(0), left_ + plot_width, bottom_}, "late");
    for (std::int64_t at = low_; at <= high_; at += step_) {
      if (at != 0) out_.line({left_, y(at)}, {left_ + plot_width, y(at)}, "grid");
      out_.text({left_ - 80, y(at) + 35}, Anchor::end, "end", amount(at));
    }
    out_.line({left_, y(0)}, {left_ + plot_width, y(0)}, "limit");
    out_.path(analyzer::chart::move_to({left_, bottom_ - plot_height}) +
                  analyzer::chart::line_to({left_, bottom_}) +
                  analyzer::chart::line_to({left_ + plot_width, bottom_}),
              "axis");
    const auto labels = labels_of(figure_);
    const std::size_t stride =
        label_stride(labels, plot_width / static_cast<Length>(std::max<std::size_t>(labels.size(), 1)));
    for (std::size_t i = 0; i < labels.size(); i += stride)
      out_.text({x(i), bottom_ + 330}, Anchor::middle, "mid", labels[i]);
    out_.text({left_ + plot_width / 2, bottom_ + 560}, Anchor::middle, "axis-name mid", figure_.name);
    out_.upright({margin + 100, bottom_ - plot_height / 2}, "axis-name mid", "least slack");
  }

  std::string title(std::size_t pair, std::size_t value) const {
    const Spot& spot = spots_[pair][value];
    std::string text = table_.pairs[pair].skill + " in " + table_.pairs[pair].environment + ", " +
                       figure_.name + " = " + figure_.choices[value].label;
    if (spot.least != no_slack) text += ": " + amount(spot.least);
    if (spot.outcome != Outcome::holds) text += std::string("; something ") + word(spot.outcome);
    return text;
  }
  static const char* word(Outcome outcome) {
    return outcome == Outcome::not_checked ? "was not checked"
           : outcome == Outcome::undecided ? "is undecided"
           : outcome == Outcome::never     ? "is never measured"
                                           : "fails";
  }

  /// The least slack is that of the whole skill only if nothing else is worse.
  void draw_line(std::size_t pair) {
    std::string path;
    bool pen = false;
    for (std::size_t i = 0; i < figure_.choices.size(); ++i) {
      const Spot& spot = spots_[pair][i];
      const bool known = spot.least != no_slack && spot.outcome == Outcome::holds;
      if (known)
        path += pen ? analyzer::chart::line_to({x(i), y(spot.least)})
                    : analyzer::chart::move_to({x(i), y(spot.least)});
      pen = known;
    }
    if (!path.empty()) out_.path(path, "curve" + colour(pair));
    const Length spread = static_cast<Length>(pair) * 34 - static_cast<Length>(spots_.size()) * 17;
    constexpr Length size = 45;
    const bool crowded = figure_.choices.size() > 150;
    for (std::size_t i = 0; i < figure_.choices.size(); ++i) {
      const Spot& spot = spots_[pair][i];
      if (spot.outcome != Outcome::holds) {
        any_cross_ = true;
        const Length at = x(i) + (crowded ? 0 : spread), line = bottom_ + 110;
        using analyzer::chart::line_to;
        using analyzer::chart::move_to;
        const std::string cross =
            spot.outcome == Outcome::fails
                ? move_to({at - size, line - size}) + line_to({at + size, line + size}) +
                      move_to({at - size, line + size}) + line_to({at + size, line - size})
                : move_to({at, line - size}) + line_to({at, line + size});
        out_.path(cross, "cross c" + std::to_string(pair % 8), title(pair, i));
      } else if (spot.least != no_slack && !crowded) {
        out_.rect({x(i) - 30, y(spot.least) - 30, x(i) + 30, y(spot.least) + 30},
                  "mark c" + std::to_string(pair % 8), title(pair, i));
      }
    }
  }

  void draw_legend() {
    const Length at = left_ + plot_width + 250;
    Length line = bottom_ - plot_height + 100;
    for (std::size_t i = 0; i < spots_.size(); ++i, line += 170) {
      const std::string text = table_.pairs[i].skill + " in " + table_.pairs[i].environment;
      out_.line({at, line - 35}, {at + 450, line - 35}, "curve" + colour(i));
      out_.text({at + 550, line}, Anchor::start, "label", text);
      legend_end_ = std::max(legend_end_, at + 550 + text_width(text, label_font));
    }
    if (any_cross_) {
      for (const char* text :
           {"below the axis, without a line:", "x: something fails that has no bound, or is no time",
            "|: something is undecided or not checked"}) {
        out_.text({at, line + 100}, Anchor::start, "small", text);
        legend_end_ = std::max(legend_end_, at + text_width(text, small_font));
        line += 150;
      }
    }
    legend_bottom_ = line + 100;
  }

  const Table& table_;
  const Figure& figure_;
  std::vector<std::vector<Spot>> spots_;  // by pair, then by value
  SvgWriter out_;
  std::int64_t low_ = 0, high_ = 0, step_ = 1;
  Length left_ = 0, bottom_ = 0, legend_end_ = 0, legend_bottom_ = 0;
  bool any_cross_ = false;
};

}  // namespace

std::string slack_plot(const Table& table, std::size_t figure) {
  return Plot(table, figure).draw();
}

}  // namespace pal::study
