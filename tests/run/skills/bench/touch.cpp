#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/contact_stiffness.hpp"
#include "tests/run/skills/bench/table.hpp"
#include "tests/run/skills/bench/touch_runs.hpp"
#include "tests/run/skills/support/physical_run.hpp"

namespace pal::test {

namespace {

constexpr int phases = 100;
constexpr double tolerance = 0.3;                  // N
constexpr double soonest = 0.028, latest = 0.067;  // s from the force to the last motion's end

}  // namespace

Overshoot touch_runs(const sim::Scene& scene, double speed, ProvedBounds* bounds) {
  Overshoot overshoot;
  for (int i = 0; i < phases / 4; ++i) {
    PhysicalRun wanted{.skill = "touch", .scene = scene.file.string()};
    wanted.parameters = {{"approach-speed", speed}, {"threshold", touch_threshold}};
    wanted.seed = static_cast<std::uint64_t>(i + 1);
    wanted.phase = sim::alter_period * (4 * i) / phases;
    wanted.raise = speed * 0.028 * std::fmod((i + 0.5) * 0.6180339887, 1.0);
    const auto result = run(wanted);
    if (bounds != nullptr) bounds->observe(result.outcome.trace);
    overshoot.ended = overshoot.ended && result.outcome.code == 0 && result.outcome.overruns == 0;
    const auto forces = pressing(result);
    overshoot.peak.add(result.peak_force - touch_threshold);
    overshoot.felt.add(*std::max_element(forces.begin(), forces.end()) - touch_threshold);
    overshoot.resting.add(result.resting_force - touch_threshold);
  }
  return overshoot;
}

std::vector<Figure> measure_touch() {
  std::vector<Figure> figures;
  for (const char* pad : {"touch", "plate-5"}) {
    for (const double speed : {5.0, 10.0, 20.0, 40.0}) {
      ProvedBounds bounds("touch");
      // The contact is the stiffer the harder it is pressed.
      const auto stiffness = [&](double reaction) {
        return sim::contact_stiffness(scene(pad), touch_threshold,
                                      touch_threshold + std::max(2.0, reaction * speed * 11));
      };
      const double soft = stiffness(soonest), stiff = stiffness(latest);
      const Overshoot overshoot = touch_runs(scene(pad), speed, &bounds);
      const double low = soonest * speed * soft - tolerance, high = latest * speed * stiff + tolerance;
      figures.push_back(observed(
          {"touch",
           fmt::format("{} mm/s, scene {} ({:.1f} to {:.1f} N/mm), seeds 1 to {}", speed, pad, soft, stiff,
                       phases / 4),
           fmt::format("overshoot {:.1f} to {:.1f} N", low, high),
           fmt::format("peak {:.1f} to {:.1f} N, felt {:.1f} to {:.1f} N, at rest {:.1f} to {:.1f} N",
                       overshoot.peak.least, overshoot.peak.greatest, overshoot.felt.least,
                       overshoot.felt.greatest, overshoot.resting.least, overshoot.resting.greatest),
           overshoot.ended && overshoot.peak.least >= low && overshoot.peak.greatest <= high},
          bounds));
    }
  }
  return figures;
}

}  // namespace pal::test
