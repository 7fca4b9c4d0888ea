// What the scripts of all plots share. Private to pal_sim.
#pragma once

#include <string>

namespace pal::sim {

struct PlotColours {
  static constexpr const char* actual = "#1a56a3";
  static constexpr const char* wanted = "#9aa0a6";
  static constexpr const char* limit = "#c4401a";
  static constexpr const char* reading = "#d9730d";
  static constexpr const char* band = "#cfe8cf";
};

/// Terminal, output, fonts, axes and grid. Sizes in pixels.
std::string plot_beginning(const std::string& name, int width, int height);

/// As a string of gnuplot's, whatever is in it.
std::string quoted(const std::string& text);

/// "title 'text' …\n", as "set" and "set multiplot" take it.
std::string heading(const std::string& text);

struct PlotRange {
  double low = 0, high = 0;
};

/// Around everything from `low` to `high`, with a tenth free on both sides, and never narrower than `least`.
PlotRange roomy(double low, double high, double least);

/// "set xrange [low:high]\n"
std::string set_range(const char* axis, const PlotRange& range);

}  // namespace pal::sim
