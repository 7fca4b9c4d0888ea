#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/devices/range_finder_emulator.hpp"
#include "tests/run/skills/bench/table.hpp"
#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/proved_bounds.hpp"

namespace pal::test {

std::vector<Figure> measure_standoff() {
  constexpr double plate = -285;  // mm: its upper side
  std::vector<Figure> figures;
  for (const double distance : {150.0, 200.0, 300.0, 445.0}) {
    ProvedBounds bounds("standoff");
    double worst = 0;
    bool ended = true;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const auto result = run({.skill = "standoff",
                               .scene = "low-plate",
                               .parameters = {{"distance", distance}, {"tolerance", 0.1}, {"speed", 3}},
                               .seed = seed});
      bounds.observe(result.outcome.trace);
      ended = ended && result.outcome.code == 0;
      worst = std::max(worst, std::abs(result.log.back().tool.z() * 1e3 - plate - distance));
    }
    const double allowed = sim::range_error(distance) / 2;
    figures.push_back(observed({"standoff", fmt::format("{} mm, scene low-plate, seeds 1 to 3", distance),
                                fmt::format("± {:.2f} mm (half of the stated error)", allowed),
                                fmt::format("± {:.3f} mm", worst), ended && worst <= allowed},
                               bounds));
  }
  return figures;
}

std::vector<Figure> measure_align() {
  constexpr double degree = std::numbers::pi / 180;
  std::vector<Figure> figures;
  struct Lean {
    const char* scene;
    double x, y;  // deg
  };
  for (const Lean& lean : {Lean{"tilted", 12, 5}, Lean{"tilted-20", -20, -8}}) {
    ProvedBounds bounds("align");
    double worst_x = 0, worst_y = 0;
    bool ended = true;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const auto result =
          run({.skill = "align", .scene = lean.scene, .parameters = {{"tolerance", 0.1}}, .seed = seed});
      bounds.observe(result.outcome.trace);
      ended = ended && result.outcome.code == 0;
      const Eigen::Vector3d normal = Eigen::AngleAxisd(lean.x * degree, Eigen::Vector3d::UnitX()) *
                                     Eigen::AngleAxisd(lean.y * degree, Eigen::Vector3d::UnitY()) *
                                     Eigen::Vector3d::UnitZ();
      const Eigen::Vector3d seen = result.log.back().tool_turn.inverse() * normal;  // in the tool's frame
      worst_x = std::max(worst_x, std::abs(std::atan2(seen.y(), -seen.z())) / degree);
      worst_y = std::max(worst_y, std::abs(std::atan2(seen.x(), -seen.z())) / degree);
    }
    figures.push_back(observed(
        {"align", fmt::format("plate at {}° and {}°, scene {}, seeds 1 to 3", lean.x, lean.y, lean.scene),
         "<= 0.1° about both axes", fmt::format("{:.3f}° about x, {:.3f}° about y", worst_x, worst_y),
         ended && worst_x <= 0.1 && worst_y <= 0.1},
        bounds));
  }
  return figures;
}

}  // namespace pal::test
