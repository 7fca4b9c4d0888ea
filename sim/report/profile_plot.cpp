#include "sim/report/profile_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/report/gnuplot.hpp"

namespace pal::sim {
namespace {

struct Extent {
  PlotRange across{1e300, -1e300}, away{1e300, -1e300};

  void include(double x, double z) {
    across = {std::min(across.low, x), std::max(across.high, x)};
    away = {std::min(away.low, z), std::max(away.high, z)};
  }
};

Extent extent(const RangeProfile& profile) {
  Extent result;
  for (const ProfilePoint& point : profile.points)
    if (point.valid) result.include(point.across, point.away);
  for (const ProfileMark& mark : profile.marks) result.include(mark.across, mark.away);
  if (result.across.low > result.across.high) result = {{-1, 1}, {0, 1}};  // nothing valid
  return result;
}

std::string points_csv(const RangeProfile& profile, bool valid) {
  std::string csv = valid ? "across_mm,away_mm\n" : "across_mm\n";
  for (const ProfilePoint& point : profile.points) {
    if (point.valid != valid) continue;
    csv += valid ? fmt::format("{:.4f},{:.4f}\n", point.across, point.away)
                 : fmt::format("{:.4f}\n", point.across);
  }
  return csv;
}

std::string lines_csv(const RangeProfile& profile) {
  std::string csv = "across_begin_mm,away_begin_mm,across_end_mm,away_end_mm\n";
  for (const ProfileLine& line : profile.lines)
    csv += fmt::format("{:.4f},{:.4f},{:.4f},{:.4f}\n", line.across_begin, line.away_begin, line.across_end,
                       line.away_end);
  return csv;
}

std::string marks_csv(const RangeProfile& profile) {
  std::string csv = "across_mm,away_mm,label\n";
  for (const ProfileMark& mark : profile.marks) {
    std::string label = mark.label;
    std::replace(label.begin(), label.end(), ',', ';');
    csv += fmt::format("{:.4f},{:.4f},{}\n", mark.across, mark.away, label);
  }
  return csv;
}

/// Files NAME_points.csv and so on, and the plot command that shows them.
std::string show(Plot& plot, const RangeProfile& profile, const std::string& name, double bottom,
                 bool keyed) {
  const auto key = [&](const char* text) {
    return keyed ? fmt::format("title '{}'", text) : std::string("notitle");
  };
  const auto has = [&](bool valid) {
    return std::any_of(profile.points.begin(), profile.points.end(),
                       [&](const auto& p) { return p.valid == valid; });
  };
  std::vector<std::string> parts;
  if (has(true)) {
    plot.data.emplace_back(name + "_points.csv", points_csv(profile, true));
    parts.push_back(fmt::format(
        "'{}_points.csv' skip 1 using 1:2 with points pointtype 7 pointsize 0.35 linecolor \"{}\" {}", name,
        PlotColours::actual, key("measured")));
  }
  if (has(false)) {
    plot.data.emplace_back(name + "_invalid.csv", points_csv(profile, false));
    parts.push_back(fmt::format(
        "'{}_invalid.csv' skip 1 using 1:({:.6g}) with points pointtype 2 pointsize 0.5 linecolor \"{}\" {}",
        name, bottom, PlotColours::wanted, key("no valid range")));
  }
  if (!profile.lines.empty()) {
    plot.data.emplace_back(name + "_lines.csv", lines_csv(profile));
    parts.push_back(
        fmt::format("'{}_lines.csv' skip 1 using 1:2:($3-$1):($4-$2) with vectors nohead linewidth 1.8 "
                    "linecolor \"{}\" {}",
                    name, PlotColours::reading, key("fitted lines")));
  }
  if (!profile.marks.empty()) {
    plot.data.emplace_back(name + "_marks.csv", marks_csv(profile));
    parts.push_back(
        fmt::format("'{}_marks.csv' skip 1 using 1:2 with points pointtype 6 pointsize 1.3 linewidth 1.6 "
                    "linecolor \"{}\" notitle",
                    name, PlotColours::limit));
    parts.push_back(fmt::format(
        "'{}_marks.csv' skip 1 using 1:2:3 with labels left offset 1.2,0.7 textcolor \"{}\" notitle", name,
        PlotColours::limit));
  }
  if (parts.empty()) parts.emplace_back("NaN notitle");
  return fmt::format("plot {}\n", fmt::join(parts, ", \\\n  "));
}

// Away from the sensor is downwards, as the sensor stands.
std::string ranges(const PlotRange& across, const PlotRange& away) {
  return set_range("x", across) + set_range("y", {away.high, away.low});
}

/// 1, 2 or 5 times a power of ten: so that a small picture has about four figures along `width`.
double tic_distance(double width) {
  const double power = std::pow(10, std::floor(std::log10(width / 4)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= width / 4) return step * power;
  return 10 * power;
}

constexpr const char* axes =
    "set size ratio -1\nset xlabel \"across, mm\"\nset ylabel \"from the sensor, mm\"\n";

}  // namespace

Plot profile_plot(const RangeProfile& profile, const std::string& name) {
  Plot plot{name, {}, {}};
  const Extent all = extent(profile);
  const PlotRange across = roomy(all.across.low, all.across.high, 4);
  const PlotRange away = roomy(all.away.low, all.away.high, 0.5 * (across.high - across.low));
  plot.script =
      plot_beginning(name, 960, 620) + "set " + heading(profile.title) + axes + ranges(across, away);
  plot.script += show(plot, profile, name, away.high, true);
  return plot;
}

Plot profiles_plot(const std::vector<RangeProfile>& profiles, const std::string& title,
                   const std::string& name) {
  Plot plot{name, {}, {}};
  double wide = 4, high = 4;
  for (const RangeProfile& profile : profiles) {
    const Extent one = extent(profile);
    wide = std::max(wide, (one.across.high - one.across.low) * 1.1);
    high = std::max(high, (one.away.high - one.away.low) * 1.25);
  }
  const auto count = std::max<std::size_t>(profiles.size(), 1);
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const std::size_t rows = (count + columns - 1) / columns;
  // As many pixels a millimetre in both directions, axes and titles apart.
  const double shape = std::clamp(high / wide, 0.45, 1.5);
  const auto each = static_cast<int>(960 / columns);
  high = std::max(high, wide * shape);
  plot.script =
      plot_beginning(name, 960, static_cast<int>(rows) * (static_cast<int>((each - 90) * shape) + 100) + 50) +
      axes +
      fmt::format("unset key\nset xtics {:g}\nset ytics {:g}\nset multiplot layout {},{} {}",
                  tic_distance(wide), tic_distance(high), rows, columns, heading(title));
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    const Extent one = extent(profiles[i]);
    const double across = (one.across.low + one.across.high) / 2, away = (one.away.low + one.away.high) / 2;
    plot.script += "set title " + quoted(profiles[i].title) + " noenhanced\n" +
                   ranges({across - wide / 2, across + wide / 2}, {away - high / 2, away + high / 2}) +
                   show(plot, profiles[i], fmt::format("{}_{}", name, i + 1), away + high / 2, false);
  }
  plot.script += "unset multiplot\n";
  return plot;
}

}  // namespace pal::sim
