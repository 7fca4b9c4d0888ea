// The pictures of a study, SVG: slack over one figure, and a map of two with the border of what holds.
#pragma once

#include <cstddef>
#include <string>

#include "study/table.hpp"

namespace pal::study {

/// A line for each skill over the values of `figure`, whatever the other figures are: the least slack of its
/// requirements that are lengths of time. A value at which something fails without a bound, or is not
/// decided, is marked and has no slack.
std::string slack_plot(const Table& table, std::size_t figure);

/// A field for each pair of values, whatever the other figures are. It shows what holds, fails or is not
/// known, and how many skills hold in all of them. A line divides fields that differ. `across` is the x axis.
std::string heat_map(const Table& table, std::size_t across, std::size_t up);

/// The file that a plot is written to: "slack-over-alter.period.svg".
std::string plot_name(const Study& study, const PlotWish& plot);

/// The plot itself.
std::string draw(const Table& table, const PlotWish& plot);

}  // namespace pal::study
