// Plots for reports, by gnuplot: data, script and picture stay together, so that a person can replot.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/report/message_log.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

/// What gnuplot needs for one picture. In its folder `gnuplot NAME.gnuplot` writes NAME.svg.
struct Plot {
  std::string name;
  std::string script;
  std::vector<std::pair<std::string, std::string>> data;  // file, CSV
};

/// A horizontal line in the plot of the force.
struct ForceLevel {
  std::string label;
  double newtons = 0;
};

struct ForceBand {
  std::string label;
  double low = 0, high = 0;  // N
};

struct ForcePlotOptions {
  std::string title;
  std::vector<ForceLevel> levels;
  std::vector<ForceBand> bands;
  std::optional<runtime::Time> end;  // of the skill
};

/// The contact force over time, the grip of a gripper's fingers, and the readings of every device that gives
/// a force fz: what the skill saw of it. Levels far above all forces of the run are left out, except the
/// lowest, because they would flatten the rest.
Plot force_plot(const std::vector<Sample>& log, const MessageLog& messages, const ForcePlotOptions& options);

/// There is something to plot: a level, a reading, or a force that was met.
bool shows_force(const std::vector<Sample>& log, const MessageLog& messages, const ForcePlotOptions& options);

/// Set-point and tool over time, an axis below the other, and the distance between them.
Plot position_plot(const std::vector<Sample>& log, const std::string& title,
                   std::optional<runtime::Time> end);

/// The way of set-point and tool in that plane of frame 0 in which the tool moved most; both axes in one
/// scale.
Plot path_plot(const std::vector<Sample>& log, const std::string& title);

/// At most about `most` rows of a table that keep every peak and every dip of `value`: the numbers of the
/// rows, ascending.
std::vector<std::size_t> telling_rows(const std::vector<double>& value, std::size_t most);

/// The plot's files: data, script and, where gnuplot is installed, the picture.
struct DrawnPlots {
  std::vector<std::pair<std::string, std::string>> files;  // name, content
  std::string problem;                                     // why there are no pictures; empty with them
};

/// Runs gnuplot on each in a folder of its own under the system's temporary folder. `gnuplot`: a name that is
/// looked up in PATH, or a path.
DrawnPlots draw(const std::vector<Plot>& plots, const std::string& gnuplot = "gnuplot");

}  // namespace pal::sim
