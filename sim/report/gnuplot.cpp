#include "sim/report/gnuplot.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "sim/report/plot.hpp"
#include "sim/report/process.hpp"

namespace pal::sim {
namespace {

namespace fs = std::filesystem;

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "pal-plots-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string svg_of(const Plot& plot, const std::string& program) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / (plot.name + ".gnuplot")) << plot.script;
  for (const auto& [name, content] : plot.data) std::ofstream(folder.path() / name) << content;
  Process gnuplot(program, {plot.name + ".gnuplot"}, folder.path().string());
  if (const auto problem = gnuplot.wait()) throw std::runtime_error(plot.name + ": " + *problem);
  std::string svg = read(folder.path() / (plot.name + ".svg"));
  if (svg.find("</svg>") == std::string::npos)
    throw std::runtime_error(plot.name + ": gnuplot wrote no whole picture");
  return svg;
}

}  // namespace

std::string plot_beginning(const std::string& name, int width, int height) {
  return fmt::format(
      "# gnuplot {0}.gnuplot   writes {0}.svg\n"
      "set terminal svg size {1},{2} font \"DejaVu Sans,13\" linewidth 1.2 background \"#ffffff\" "
      "noenhanced\n"
      "set output \"{0}.svg\"\n"
      "set datafile separator comma\n"
      "set encoding utf8\n"
      "set border 3 linecolor \"#555555\"\n"
      "set tics nomirror out textcolor \"#333333\"\n"
      "set grid linecolor \"#dddddd\" linetype 1 linewidth 0.6\n"
      "set key below center horizontal height 0.6 noenhanced\n",
      name, width, height);
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\n') continue;
    result += c;
    if (c == '\'') result += c;
  }
  return result + "'";
}

std::string heading(const std::string& text) {
  return "title " + quoted(text) + " font \"DejaVu Sans Bold,15\" noenhanced\n";
}

PlotRange roomy(double low, double high, double least) {
  const double half = std::max((high - low) * 0.55, least / 2), middle = (low + high) / 2;
  return {middle - half, middle + half};
}

std::string set_range(const char* axis, const PlotRange& range) {
  return fmt::format("set {}range [{:.6g}:{:.6g}]\n", axis, range.low, range.high);
}

DrawnPlots draw(const std::vector<Plot>& plots, const std::string& gnuplot) {
  DrawnPlots drawn;
  const auto program = find_program(gnuplot);
  if (!program) drawn.problem = gnuplot + " is not installed (apt-get install gnuplot-nox)";
  for (const Plot& plot : plots) {
    drawn.files.insert(drawn.files.end(), plot.data.begin(), plot.data.end());
    drawn.files.emplace_back(plot.name + ".gnuplot", plot.script);
    if (!drawn.problem.empty()) continue;
    try {
      drawn.files.emplace_back(plot.name + ".svg", svg_of(plot, *program));
    } catch (const std::exception& problem) {
      drawn.problem = problem.what();
    }
  }
  return drawn;
}

}  // namespace pal::sim
