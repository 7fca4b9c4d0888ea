// The plots of a run's forces and positions.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/report/gnuplot.hpp"
#include "sim/report/plot.hpp"

namespace pal::sim {
namespace {

constexpr std::size_t most_rows = 2000;

double seconds(runtime::Time time) {
  return std::chrono::duration<double>(time).count();
}

double last_second(const std::vector<Sample>& log) {
  return log.empty() ? 1 : std::max(seconds(log.back().time), 1e-3);
}

std::string end_of_skill(const std::optional<runtime::Time>& end, bool labelled) {
  if (!end) return {};
  std::string text = fmt::format(
      "set arrow from {0:.4f}, graph 0 to {0:.4f}, graph 1 nohead dashtype 3 linewidth 1.5 linecolor "
      "\"#666666\"\n",
      seconds(*end));
  if (labelled)
    text += fmt::format(
        "set label \"skill ends\" at {:.4f}, graph 0.97 right offset -0.6,0 textcolor \"#555555\"\n",
        seconds(*end));
  return text;
}

struct Readings {
  std::string name;  // device and message
  std::string csv;
  double least = 0, greatest = 0;
};

/// Every port from a device with a field fz in newtons, from which anything came. Pressing gives a negative
/// fz: turned round, it lies over the contact force.
std::vector<Readings> force_readings(const MessageLog& messages) {
  std::vector<Readings> result;
  for (std::size_t device = 0; device < messages.devices().size(); ++device) {
    const MessageLog::DeviceNames& names = messages.devices()[device];
    for (std::size_t port = 0; port < names.ports.size(); ++port) {
      const auto& fields = names.ports[port].fields;
      const auto fz = std::find(fields.begin(), fields.end(), runtime::FieldSpec{"fz", "N"});
      if (names.ports[port].to_device || fz == fields.end()) continue;
      Readings readings{names.name + " " + names.ports[port].message, "time_s,pressing_N\n"};
      messages.for_each([&](const LoggedMessage& message) {
        if (message.device != device || message.port != port) return;
        const double force = -message.fields[static_cast<std::size_t>(fz - fields.begin())];
        readings.csv += fmt::format("{:.6f},{:.4f}\n", seconds(message.time), force);
        readings.least = std::min(readings.least, force);
        readings.greatest = std::max(readings.greatest, force);
      });
      if (readings.csv.back() == '\n' && std::count(readings.csv.begin(), readings.csv.end(), '\n') > 1)
        result.push_back(std::move(readings));
    }
  }
  return result;
}

/// With which each finger presses on what is between them; nothing: there was no grip.
std::optional<std::string> grip_csv(const std::vector<Sample>& log) {
  std::vector<double> grip;
  for (const Sample& sample : log) grip.push_back(sample.grip_force);
  if (std::none_of(grip.begin(), grip.end(), [](double newtons) { return newtons > 0; })) return std::nullopt;
  std::string csv = "time_s,grip_force_N\n";
  for (const std::size_t row : telling_rows(grip, most_rows))
    csv += fmt::format("{:.3f},{:.4f}\n", seconds(log[row].time), grip[row]);
  return csv;
}

constexpr double far_above = 2.5;  // times the greatest force

/// Those that are not far above `high`, and the lowest.
std::vector<ForceLevel> near_levels(const std::vector<ForceLevel>& levels, double high) {
  double lowest = 1e300;
  for (const ForceLevel& level : levels) lowest = std::min(lowest, level.newtons);
  std::vector<ForceLevel> near;
  for (const ForceLevel& level : levels)
    if (level.newtons <= std::max(far_above * high, lowest)) near.push_back(level);
  return near;
}

}  // namespace

bool shows_force(const std::vector<Sample>& log, const MessageLog& messages,
                 const ForcePlotOptions& options) {
  if (!options.levels.empty() || !options.bands.empty() || !force_readings(messages).empty()) return true;
  return std::any_of(log.begin(), log.end(),
                     [](const Sample& sample) { return sample.contact_force > 0 || sample.grip_force > 0; });
}

std::vector<std::size_t> telling_rows(const std::vector<double>& value, std::size_t most) {
  std::vector<std::size_t> rows;
  const std::size_t bin = std::max<std::size_t>(1, (2 * value.size() + most - 1) / most);
  const auto at = [&](std::size_t i) { return value.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t begin = 0; begin < value.size(); begin += bin) {
    const auto [least, greatest] = std::minmax_element(at(begin), at(std::min(begin + bin, value.size())));
    const auto first = static_cast<std::size_t>(least - value.begin());
    const auto second = static_cast<std::size_t>(greatest - value.begin());
    rows.push_back(std::min(first, second));
    if (first != second) rows.push_back(std::max(first, second));
  }
  return rows;
}

Plot force_plot(const std::vector<Sample>& log, const MessageLog& messages, const ForcePlotOptions& options) {
  std::vector<double> force;
  for (const Sample& sample : log) force.push_back(sample.contact_force);
  std::string csv = "time_s,contact_force_N\n";
  for (const std::size_t row : telling_rows(force, most_rows))
    csv += fmt::format("{:.3f},{:.4f}\n", seconds(log[row].time), force[row]);
  Plot plot{"force", {}, {{"force.csv", csv}}};

  double low = 0, high = 1;
  for (const double newtons : force) high = std::max(high, newtons);
  std::string grip;
  if (const auto gripped = grip_csv(log)) {
    plot.data.emplace_back("grip.csv", *gripped);
    for (const Sample& sample : log) high = std::max(high, sample.grip_force);
    grip = fmt::format(
        ", \\\n  'grip.csv' skip 1 using 1:2 with lines linewidth 1.6 linecolor \"{}\" title 'grip of each "
        "finger'",
        PlotColours::wanted);
  }
  for (const ForceBand& band : options.bands) high = std::max(high, band.high);
  std::string readings;
  for (const Readings& device : force_readings(messages)) {
    const std::string file = fmt::format("force_readings{}.csv", plot.data.size());
    plot.data.emplace_back(file, device.csv);
    low = std::min(low, device.least);
    high = std::max(high, device.greatest);
    readings += fmt::format(
        ", \\\n  {} skip 1 using 1:2 with points pointtype 6 pointsize 0.5 linecolor \"{}\" title {}",
        quoted(file), PlotColours::reading, quoted("as read by the skill: " + device.name));
  }
  const std::vector<ForceLevel> levels = near_levels(options.levels, high);
  for (const ForceLevel& level : levels) high = std::max(high, level.newtons);
  plot.script = plot_beginning(plot.name, 960, 480) + "set " + heading(options.title) +
                "set xlabel \"time, s\"\nset ylabel \"force, N\"\n" + set_range("x", {0, last_second(log)}) +
                set_range("y", {low < 0 ? low * 1.1 : 0, high * 1.12}) + end_of_skill(options.end, true);
  for (const ForceBand& band : options.bands)
    plot.script += fmt::format(
        "set object rectangle from graph 0, first {:g} to graph 1, first {:g} fillcolor \"{}\" fillstyle "
        "solid noborder behind\n"
        "set label {} at graph 0.01, first {:g} textcolor \"#3c7a3c\"\n",
        band.low, band.high, PlotColours::band, quoted(band.label), (band.low + band.high) / 2);
  for (const ForceLevel& level : levels)
    plot.script += fmt::format(
        "set arrow from graph 0, first {0:g} to graph 1, first {0:g} nohead dashtype 2 linewidth 1.3 "
        "linecolor \"{1}\"\n"
        "set label {2} at graph 0.01, first {0:g} offset 0,0.6 textcolor \"{1}\"\n",
        level.newtons, PlotColours::limit, quoted(fmt::format("{} {:g} N", level.label, level.newtons)));
  plot.script += fmt::format(
      "plot 'force.csv' skip 1 using 1:2 with lines linewidth 1.6 linecolor \"{}\" title 'contact "
      "force'{}{}\n",
      PlotColours::actual, grip, readings);
  return plot;
}

Plot position_plot(const std::vector<Sample>& log, const std::string& title,
                   std::optional<runtime::Time> end) {
  std::vector<double> error;
  std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const Sample& sample : log) {
    error.push_back((sample.tool - sample.set_point).norm() * 1e3);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const Eigen::Vector3d* place : {&sample.tool, &sample.set_point}) {
        low[axis] = std::min(low[axis], (*place)[static_cast<Eigen::Index>(axis)] * 1e3);
        high[axis] = std::max(high[axis], (*place)[static_cast<Eigen::Index>(axis)] * 1e3);
      }
  }
  std::string csv =
      "time_s,set_point_x_mm,set_point_y_mm,set_point_z_mm,tool_x_mm,tool_y_mm,tool_z_mm,following_error_"
      "mm\n";
  for (const std::size_t row : telling_rows(error, most_rows)) {
    const Eigen::Vector3d wanted = log[row].set_point * 1e3, actual = log[row].tool * 1e3;
    csv += fmt::format("{:.3f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n", seconds(log[row].time),
                       wanted.x(), wanted.y(), wanted.z(), actual.x(), actual.y(), actual.z(), error[row]);
  }
  Plot plot{"position", {}, {{"position.csv", csv}}};
  plot.script = plot_beginning(plot.name, 960, 900) +
                "set multiplot layout 4,1 margins 0.13,0.97,0.075,0.93 spacing 0.0,0.03 " + heading(title) +
                set_range("x", {0, last_second(log)}) + end_of_skill(end, false) +
                "set format y \"%8g\"\nset format x \"\"\n";
  constexpr std::array<const char*, 3> names{"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const PlotRange range = log.empty() ? PlotRange{-1, 1} : roomy(low[axis], high[axis], 0.4);
    plot.script += fmt::format(
        "set ylabel \"{0}, mm\"\n{1}{6}plot 'position.csv' skip 1 using 1:{2} with lines linewidth 2.6 "
        "linecolor \"{3}\" title 'set-point', \\\n"
        "  '' skip 1 using 1:{4} with lines linewidth 1.2 linecolor \"{5}\" title 'tool'\n",
        names[axis], set_range("y", range), 2 + axis, PlotColours::wanted, 5 + axis, PlotColours::actual,
        axis == 0 ? "set key at graph 1, graph 1.16 right top horizontal\n" : "unset key\n");
  }
  plot.script += fmt::format(
      "set ylabel \"following error, mm\"\nset xlabel \"time, s\"\nset format x \"%g\"\n"
      "set yrange [0:*]\nplot 'position.csv' skip 1 using 1:8 with lines linecolor \"{}\" notitle\nunset "
      "multiplot\n",
      PlotColours::limit);
  return plot;
}

Plot path_plot(const std::vector<Sample>& log, const std::string& title) {
  Eigen::Array3d low = Eigen::Array3d::Constant(1e300), high = -low;
  for (const Sample& sample : log) {
    low = low.min(sample.tool.array() * 1e3).min(sample.set_point.array() * 1e3);
    high = high.max(sample.tool.array() * 1e3).max(sample.set_point.array() * 1e3);
  }
  if (log.empty()) low.setZero(), high.setZero();
  // The axis of the least movement is the one that is looked along.
  Eigen::Index along = 0;
  (high - low).minCoeff(&along);
  const Eigen::Index across = along == 0 ? 1 : 0, upwards = along == 2 ? 1 : 2;
  constexpr std::array<const char*, 3> names{"x", "y", "z"};
  const char* first = names[static_cast<std::size_t>(across)];
  const char* second = names[static_cast<std::size_t>(upwards)];

  const std::size_t step = log.size() / most_rows + 1;
  std::string csv =
      fmt::format("time_s,set_point_{0}_mm,set_point_{1}_mm,tool_{0}_mm,tool_{1}_mm\n", first, second);
  for (std::size_t row = 0; row < log.size(); row += step) {
    const Eigen::Vector3d wanted = log[row].set_point * 1e3, actual = log[row].tool * 1e3;
    csv += fmt::format("{:.3f},{:.4f},{:.4f},{:.4f},{:.4f}\n", seconds(log[row].time), wanted[across],
                       wanted[upwards], actual[across], actual[upwards]);
  }
  Plot plot{"path", {}, {{"path.csv", csv}}};
  const double widest = std::max((high - low).maxCoeff(), 2.0);
  const PlotRange horizontal = roomy(low[across], high[across], 0.6 * widest);
  const PlotRange vertical = roomy(low[upwards], high[upwards], 0.6 * widest);
  plot.script =
      plot_beginning(plot.name, 760, 700) + "set " + heading(title) + "set size ratio -1\n" +
      fmt::format("set xlabel \"{}, mm\"\nset ylabel \"{}, mm\"\n", first, second) +
      set_range("x", horizontal) + set_range("y", vertical) +
      fmt::format(
          "plot 'path.csv' skip 1 using 2:3 with lines linewidth 3 linecolor \"{0}\" title 'set-point', \\\n"
          "  '' skip 1 using 4:5 with lines linewidth 1.2 linecolor \"{1}\" title 'tool', \\\n"
          "  '' skip 1 every ::0::0 using 4:5 with points pointtype 6 pointsize 1 linecolor \"{1}\" title "
          "'begin', \\\n"
          "  '' skip {2} using 4:5 with points pointtype 7 pointsize 0.8 linecolor \"{1}\" title 'end'\n",
          PlotColours::wanted, PlotColours::actual, std::count(csv.begin(), csv.end(), '\n') - 1);
  return plot;
}

}  // namespace pal::sim
