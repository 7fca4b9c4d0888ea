#include <fmt/format.h>

#include <algorithm>

#include "tests/run/skills/bench/table.hpp"
#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/workshop.hpp"

namespace pal::test {

namespace {

using Eigen::Vector3d;

constexpr double speed = 250;              // mm/s
constexpr double line = 0.15, end = 0.05;  // mm, to reach
// Joints 1 and 4 carry no weight, and may lie on either side of their play: 0.06 mrad at 0.65 m, 0.15 mrad at
// 0.2 m.
constexpr double play = 0.07;  // mm
constexpr runtime::Time settled = std::chrono::milliseconds(150);

struct Errors {
  double line = 0;  // mm from the straight line, at most, while the set-point moves
  double end = 0;   // mm from where it was told to go, from 150 ms after the set-point's rest on, at most
};

Errors errors_of(std::span<const sim::Sample> log, const Vector3d& goal) {
  const Vector3d begin = log.front().set_point, way = (log.back().set_point - begin).normalized();
  std::size_t rest = log.size() - 1;
  while (rest > 0 && (log[rest - 1].set_point - log.back().set_point).norm() < 1e-9) --rest;
  Errors errors;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (i <= rest) errors.line = std::max(errors.line, 1e3 * (log[i].tool - begin).cross(way).norm());
    if (log[i].time >= log[rest].time + settled)
      errors.end = std::max(errors.end, (1e3 * log[i].tool - goal).norm());
  }
  return errors;
}

/// Four straight lines, there and back; by move-cartesian and by relative-move.
Errors four_lines(const sim::Scene& scene, bool relative, ProvedBounds& bounds, bool& ended) {
  const std::vector<Vector3d> corners{{460, 50, 0}, {560, 50, -150}, {560, -230, -150}, {460, -200, 0}};
  Workshop shop(scene);
  Vector3d before = shop.location("HOME");
  Errors worst;
  for (const Vector3d& corner : corners) {
    const Vector3d way = corner - before;
    // The tool points straight down: its y and z are against those of frame 0.
    const auto outcome = relative ? shop.run("relative-move",
                                             {{.name = "dx", .value = way.x()},
                                              {.name = "dy", .value = -way.y()},
                                              {.name = "dz", .value = -way.z()},
                                              {.name = "speed", .value = speed}},
                                             bounds)
                                  : shop.run("move-cartesian",
                                             {{.name = "x", .value = corner.x()},
                                              {.name = "y", .value = corner.y()},
                                              {.name = "z", .value = corner.z()},
                                              {.name = "speed", .value = speed}},
                                             bounds);
    ended = ended && outcome.code == 0 && outcome.overruns == 0;
    // A relative move goes from where the encoders see the tool; its set-point is where it was told to go.
    const Vector3d goal = relative ? Vector3d(1e3 * shop.log().back().set_point) : corner;
    const Errors errors = errors_of(shop.log(), goal);
    worst.line = std::max(worst.line, errors.line);
    worst.end = std::max(worst.end, errors.end);
    before = corner;
  }
  return worst;
}

Figure straight(const std::string& skill, bool relative, const std::string& machine) {
  const ChangedScene changed("nothing", "machine " + machine);
  ProvedBounds bounds(skill);
  bool ended = true;
  const Errors errors = four_lines(changed.scene(), relative, bounds, ended);
  const double most = machine == "exact" ? end : end + play;
  return observed({skill, fmt::format("four lines at 0.25 m/s, machine {}", machine),
                   fmt::format("line <= {} mm, end <= {:.2f} mm after 150 ms", line, most),
                   fmt::format("line {:.3f} mm, end {:.3f} mm", errors.line, errors.end),
                   ended && errors.line <= line && errors.end <= most},
                  bounds);
}

Figure joint(const std::string& machine) {
  const ChangedScene changed("parts", "machine " + machine);
  Workshop shop(changed.scene());
  ProvedBounds bounds("move-to-location");
  bool ended = true;
  double worst = 0;
  for (const char* location : {"PLACE", "HOME", "PLACE", "HOME"}) {
    const auto outcome =
        shop.run("move-to-location", {text("location", location), {.name = "speed", .value = 100}}, bounds);
    ended = ended && outcome.code == 0 && outcome.overruns == 0;
    worst = std::max(worst, errors_of(shop.log(), shop.location(location)).end);
  }
  const double most = machine == "exact" ? end : end + play;
  return observed({"move-to-location", fmt::format("320 mm and back twice at 100 %, machine {}", machine),
                   fmt::format("end <= {:.2f} mm after 150 ms", most), fmt::format("end {:.3f} mm", worst),
                   ended && worst <= most},
                  bounds);
}

}  // namespace

std::vector<Figure> measure_moves() {
  std::vector<Figure> figures;
  for (const char* machine : {"exact", "seed 1", "seed 2", "seed 3"}) {
    figures.push_back(joint(machine));
    figures.push_back(straight("move-cartesian", false, machine));
    figures.push_back(straight("relative-move", true, machine));
  }
  return figures;
}

}  // namespace pal::test
