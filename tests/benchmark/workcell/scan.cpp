// What the range finder's rays cost beside the physics.
#include <fmt/format.h>

#include <algorithm>

#include "sim/cell/cell.hpp"
#include "sim/workcell.hpp"
#include "tests/benchmark/workcell/clock.hpp"
#include "tests/benchmark/workcell/row.hpp"

namespace pal::bench {
namespace {

using namespace std::chrono_literals;

/// CPU seconds of `seconds` of the scene, with three rays each millisecond (255 in 76 ms are 3.4) or none.
double cost(const char* scene, runtime::Time length, bool scanning) {
  sim::Workcell workcell(sim::find_scene(scene, {PAL_SCENE_DIR}), {.keep_log = false});
  constexpr double half_fan = 20 * M_PI / 180;
  const double begin = cpu_seconds();
  int ray = 0;
  for (runtime::Time t = 1ms; t <= length; t += 1ms) {
    workcell.advance_to(t);
    const sim::Pose pose = workcell.tool();
    for (const int last = scanning ? static_cast<int>(255.0 / 76 * static_cast<double>(t / 1ms)) : ray;
         ray < last; ++ray) {
      const double angle = half_fan * (2.0 * (ray % 255) / 254 - 1);
      const Eigen::Vector3d direction = pose.linear() * Eigen::Vector3d(0, std::sin(angle), std::cos(angle));
      workcell.cast(pose.translation(), direction);
    }
  }
  return cpu_seconds() - begin;
}

}  // namespace

std::vector<Row> scan_rows() {
  std::vector<Row> rows;
  for (const char* scene : {"pyramid", "seam"}) {
    std::vector<double> parts;
    for (int round = 0; round < 5; ++round) {
      const double without = cost(scene, 4s, false);
      parts.push_back(cost(scene, 4s, true) / without - 1);
    }
    std::sort(parts.begin(), parts.end());
    const double part = parts[parts.size() / 2];
    rows.push_back({fmt::format("range finder scanning without pause, scene {}", scene),
                    fmt::format("+{:.0f} %", 100 * part), "at most +40 %", part <= 0.4});
  }
  return rows;
}

}  // namespace pal::bench
