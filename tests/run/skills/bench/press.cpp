#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/run/skills/bench/table.hpp"
#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/proved_bounds.hpp"

namespace pal::test {

std::vector<Figure> measure_press() {
  constexpr double force = 5, time = 2;
  std::vector<Figure> figures;
  for (const char* plate : {"plate-1", "plate-5", "plate-20", "touch"}) {
    ProvedBounds bounds("press");
    double greatest = 0, squares = 0, count = 0, peak = 0;
    bool ended = true;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const auto result = run(
          {.skill = "press", .scene = plate, .parameters = {{"force", force}, {"time", time}}, .seed = seed});
      bounds.observe(result.outcome.trace);
      ended = ended && result.outcome.code == 0 && result.outcome.overruns == 0;
      const auto forces = pressing(result);
      const double end = std::chrono::duration<double>(result.outcome.duration).count();
      for (std::size_t i = 0; i < forces.size(); ++i) {
        const double when = std::chrono::duration<double>(result.log[i].time).count();
        peak = std::max(peak, forces[i]);
        if (when < end - time || when > end) continue;
        greatest = std::max(greatest, std::abs(forces[i] - force));
        squares += (forces[i] - force) * (forces[i] - force);
        ++count;
      }
    }
    const double rms = count > 0 ? std::sqrt(squares / count) : 1e9;
    figures.push_back(
        {"press", fmt::format("5 N for 2 s, scene {}, seeds 1 to 5", plate), "± 0.3 N, rms <= 0.1 N",
         fmt::format("± {:.2f} N, rms {:.3f} N; peak while landing {:.1f} N", greatest, rms, peak),
         ended && greatest <= 0.3 && rms <= 0.1, bounds.greatest_part()});
  }
  return figures;
}

}  // namespace pal::test
