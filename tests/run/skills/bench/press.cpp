#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/run/skills/bench/press_runs.hpp"
#include "tests/run/skills/bench/table.hpp"
#include "tests/run/skills/support/physical_run.hpp"

namespace pal::test {

Held press_runs(const std::string& plate, const std::string& lines, ProvedBounds* bounds) {
  Held held;
  double squares = 0, count = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto result = run({.skill = "press",
                             .scene = plate,
                             .parameters = {{"force", press_force}, {"time", press_time}},
                             .seed = seed,
                             .lines = lines});
    if (bounds != nullptr) bounds->observe(result.outcome.trace);
    held.ended = held.ended && result.outcome.code == 0 && result.outcome.overruns == 0;
    const auto forces = pressing(result);
    double of_run = 0, samples = 0;
    const double end = std::chrono::duration<double>(result.outcome.duration).count();
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const double when = std::chrono::duration<double>(result.log[i].time).count();
      held.peak = std::max(held.peak, forces[i]);
      if (when < end - press_time || when > end) continue;
      const double off = forces[i] - press_force;
      held.greatest = std::max(held.greatest, std::abs(off));
      of_run += off * off;
      ++samples;
    }
    squares += of_run;
    count += samples;
    if (samples > 0) held.worst_rms = std::max(held.worst_rms, std::sqrt(of_run / samples));
  }
  if (count > 0) held.rms = std::sqrt(squares / count);
  return held;
}

std::vector<Figure> measure_press() {
  std::vector<Figure> figures;
  for (const char* machine : {"1", "2", "3"}) {
    for (const char* plate : {"plate-1", "plate-5", "plate-20", "touch"}) {
      ProvedBounds bounds("press");
      const Held held = press_runs(plate, fmt::format("machine seed {}", machine), &bounds);
      figures.push_back(observed(
          {"press", fmt::format("5 N for 2 s, scene {}, machine seed {}, seeds 1 to 5", plate, machine),
           "± 0.3 N, rms <= 0.1 N in each run",
           fmt::format("± {:.2f} N, rms {:.3f} N, at most {:.3f} N in a run; peak while landing {:.1f} N",
                       held.greatest, held.rms, held.worst_rms, held.peak),
           held.ended && held.greatest <= 0.3 && held.worst_rms <= 0.1},
          bounds));
    }
  }
  return figures;
}

}  // namespace pal::test
