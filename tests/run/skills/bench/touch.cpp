#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/press.hpp"
#include "tests/run/skills/bench/table.hpp"
#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/proved_bounds.hpp"

namespace pal::test {

namespace {

constexpr double threshold = 5;  // N
constexpr int phases = 100;
constexpr double tolerance = 0.3;                  // N
constexpr double soonest = 0.028, latest = 0.067;  // s from the force to the last motion's end

}  // namespace

std::vector<Figure> measure_touch() {
  std::vector<Figure> figures;
  for (const char* pad : {"touch", "plate-5"}) {
    for (const double speed : {5.0, 10.0, 20.0, 40.0}) {
      ProvedBounds bounds("touch");
      // The contact is the stiffer the harder it is pressed.
      const auto stiffness = [&](double reaction) {
        return sim::contact_stiffness(scene(pad), threshold,
                                      threshold + std::max(2.0, reaction * speed * 11));
      };
      const double soft = stiffness(soonest), stiff = stiffness(latest);
      double least = 1e9, greatest = 0, resting_least = 1e9, resting_greatest = 0;
      bool ended = true;
      for (int i = 0; i < phases / 4; ++i) {
        PhysicalRun wanted{.skill = "touch", .scene = pad};
        wanted.parameters = {{"approach-speed", speed}, {"threshold", threshold}};
        wanted.seed = static_cast<std::uint64_t>(i + 1);
        wanted.phase = sim::alter_period * (4 * i) / phases;
        wanted.raise = speed * 0.028 * std::fmod((i + 0.5) * 0.6180339887, 1.0);
        const auto result = run(wanted);
        bounds.observe(result.outcome.trace);
        ended = ended && result.outcome.code == 0 && result.outcome.overruns == 0;
        least = std::min(least, result.peak_force - threshold);
        greatest = std::max(greatest, result.peak_force - threshold);
        resting_least = std::min(resting_least, result.resting_force - threshold);
        resting_greatest = std::max(resting_greatest, result.resting_force - threshold);
      }
      const double low = soonest * speed * soft - tolerance, high = latest * speed * stiff + tolerance;
      figures.push_back({"touch",
                         fmt::format("{} mm/s, scene {} ({:.1f} to {:.1f} N/mm), seeds 1 to {}", speed, pad,
                                     soft, stiff, phases / 4),
                         fmt::format("overshoot {:.1f} to {:.1f} N", low, high),
                         fmt::format("peak {:.1f} to {:.1f} N, at rest {:.1f} to {:.1f} N", least, greatest,
                                     resting_least, resting_greatest),
                         ended && least >= low && greatest <= high, bounds.greatest_part()});
    }
  }
  return figures;
}

}  // namespace pal::test
