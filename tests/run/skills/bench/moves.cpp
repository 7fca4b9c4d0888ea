#include <fmt/format.h>

#include <algorithm>

#include "tests/run/skills/bench/table.hpp"
#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/proved_bounds.hpp"

namespace pal::test {

std::vector<Figure> measure_moves() {
  std::vector<Figure> figures;
  const Eigen::Vector3d goal(420, 60, 150);
  for (const double speed : {100.0, 250.0}) {
    ProvedBounds bounds("move-cartesian");
    const auto result =
        run({.skill = "move-cartesian",
             .scene = "flat",
             .parameters = {{"x", goal.x()}, {"y", goal.y()}, {"z", goal.z()}, {"speed", speed}}});
    bounds.observe(result.outcome.trace);
    const Eigen::Vector3d start = result.log.front().tool * 1e3;
    const Eigen::Vector3d along = (goal - start).normalized();
    double off_line = 0, end = 0;
    const runtime::Time rest = result.outcome.duration + std::chrono::milliseconds(150);
    for (const sim::Sample& sample : result.log) {
      const Eigen::Vector3d way = sample.tool * 1e3 - start;
      off_line = std::max(off_line, (way - way.dot(along) * along).norm());
      if (sample.time <= rest) end = (sample.tool * 1e3 - goal).norm();
    }
    // What the encoders cannot see: the play of the gears, which the scene's machine has.
    const double backlash = 0.05;
    figures.push_back({"move-cartesian",
                       fmt::format("{:.0f} mm at {} mm/s, scene flat, seed 1", (goal - start).norm(), speed),
                       "line <= 0.15 mm; end <= 0.05 mm and play of 0.05 mm",
                       fmt::format("line {:.2f} mm, end {:.3f} mm 150 ms after the end", off_line, end),
                       result.outcome.code == 0 && off_line <= 0.15 && end <= 0.05 + backlash,
                       bounds.greatest_part()});
  }
  return figures;
}

}  // namespace pal::test
