// Surfaces that are given by heights.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "sim/model/mjcf.hpp"

namespace pal::sim {
namespace {

constexpr double tau = 2 * std::numbers::pi;

// `height` of the point at (x, y), mm from the thing's middle.
Heights sampled(const Thing& thing, int rows, int columns,
                const std::function<double(double x, double y)>& height) {
  const std::vector<double>& size = thing.all("size");
  std::vector<double> values;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      values.push_back(height(size[0] * (static_cast<double>(column) / (columns - 1) - 0.5),
                              size[1] * (static_cast<double>(row) / (rows - 1) - 0.5)));
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  Heights heights{thing.name, rows, columns, std::max(*greatest - *least, 1e-3), {}};
  for (const double value : values)
    heights.values.push_back(static_cast<float>((value - *least) / heights.span));
  return heights;
}

int cells(double length, double at_most) {
  return 1 + static_cast<int>(std::ceil(length / at_most));
}

constexpr int coarser_by = 8;

// As cells(), so that each eighth point is one of the coarser field's.
int cells_in_eighths(double length, double at_most) {
  return 1 + coarser_by * static_cast<int>(std::ceil(length / at_most / coarser_by));
}

// Where the seam of a surface is, mm from its middle line.
double seam_at(const Thing& thing, double x) {
  return thing.one("swing") * std::sin(tau * x / (1.7 * thing.one("length")));
}

}  // namespace

Heights wave_heights(const Thing& thing) {
  // Strips of 2 mm are flat to a hundredth of a millimetre at the usual waves. A finer grid would give the
  // tip more points of contact than MuJoCo takes.
  constexpr double strip = 2.0;
  const double height = thing.one("height"), length = thing.one("length");
  return sampled(thing, 2, cells(thing.all("size")[0], strip),
                 [&](double x, double) { return 0.5 * height * (1 - std::cos(tau * x / length)); });
}

Heights surface_heights(const Thing& thing) {
  // Across the seam the range finder's points are 0.6 mm apart at 200 mm.
  constexpr double across = 0.5, along = 1.25;
  const double height = thing.one("height"), length = thing.one("length");
  const double fall = std::tan(radians(thing.one("slope"))), step = thing.one("step");
  const std::vector<double>& size = thing.all("size");
  const int rows = cells_in_eighths(size[1], across);
  // A step takes one row of cells. The nearer side ends at the points that are nearest to the seam.
  const double nearest = 0.5 * size[1] / (rows - 1);
  return sampled(thing, rows, cells_in_eighths(size[0], along), [&](double x, double y) {
    const double seam = seam_at(thing, x);
    return 0.5 * height * std::sin(tau * x / length) - fall * std::abs(y - seam) -
           (y < seam - nearest ? step : 0);
  });
}

std::vector<std::array<double, 3>> seam_of(const Thing& thing, const Heights& fine) {
  constexpr int points = 61;
  const std::vector<double>& size = thing.all("size");
  std::vector<std::array<double, 3>> seam;
  for (int i = 0; i < points; ++i) {
    const double x = size[0] * (static_cast<double>(i) / (points - 1) - 0.5);
    const double y = seam_at(thing, x);
    if (std::abs(y) > size[1] / 2) continue;
    const auto row = std::lround((y / size[1] + 0.5) * (fine.rows - 1));
    const auto column = std::lround((x / size[0] + 0.5) * (fine.columns - 1));
    seam.push_back({x, y, fine.span * fine.values[static_cast<std::size_t>(row * fine.columns + column)]});
  }
  return seam;
}

Heights coarser(const Heights& fine) {
  Heights coarse{fine.name + "/felt",
                 1 + (fine.rows - 1) / coarser_by,
                 1 + (fine.columns - 1) / coarser_by,
                 fine.span,
                 {}};
  for (int row = 0; row < fine.rows; row += coarser_by)
    for (int column = 0; column < fine.columns; column += coarser_by)
      coarse.values.push_back(fine.values[static_cast<std::size_t>(row * fine.columns + column)]);
  return coarse;
}

}  // namespace pal::sim
