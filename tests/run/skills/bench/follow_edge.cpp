#include <fmt/format.h>

#include <cmath>

#include "tests/run/skills/bench/table.hpp"
#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/proved_bounds.hpp"
#include "tests/run/skills/support/seam.hpp"

namespace pal::test {

std::vector<Figure> measure_follow_edge() {
  const Seam seam;
  constexpr double standoff = 200,
                   settled = 40;                       // mm
  constexpr double translation = 0.5, rotation = 0.5;  // of both laws
  std::vector<Figure> figures;
  struct Law {
    const char* scene;
    bool literal;
  };
  for (const auto& [scene, literal] : {Law{"seam-crease", false}, Law{"seam-step", false},
                                       Law{"seam-wide", false}, Law{"seam-wide", true}}) {
    for (const double speed : {10.0, 30.0}) {
      ProvedBounds bounds("follow-edge");
      double lengths = 0, turns = 0, count = 0;
      bool ended = true;
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const auto result = run({.skill = "follow-edge",
                                 .scene = scene,
                                 .parameters = {{"track", speed * 0.028},
                                                {"distance", 20},
                                                {"translation", translation},
                                                {"rotation", rotation},
                                                {"history", 10},
                                                {"standoff", standoff / 10},
                                                {"literal", literal ? 1.0 : 0.0}},
                                 .seed = seed});
        bounds.observe(result.outcome.trace);
        ended = ended && result.outcome.code == 0 && result.outcome.overruns == 0;
        const double start = result.log.front().tool.x();
        for (const sim::Sample& sample : result.log) {
          if (sample.time > result.outcome.duration || (sample.tool.x() - start) * 1e3 < settled) continue;
          const OffSeam now = off(seam, sample, standoff);
          lengths += now.length * now.length;
          turns += now.turn * now.turn;
          ++count;
        }
      }
      const double length = std::sqrt(lengths / count), turn = std::sqrt(turns / count);
      const double most_length = speed <= 10 ? 0.25 : 0.4, most_turn = speed <= 10 ? 2.5 : 3.5;
      figures.push_back(observed(
          {"follow-edge",
           fmt::format("{}, {} mm/s, scene {}, seeds 1 to 3; 200 mm far, translation {} mm, rotation {}°, "
                       "history 10 mm, standoff 200 mm; from {} mm on",
                       literal ? "the thesis's law" : "by the map of the edge", speed, scene, translation,
                       rotation, settled),
           literal ? "reported" : fmt::format("<= {} mm rms, <= {}° rms", most_length, most_turn),
           count == 0 ? std::string("the edge is lost in the first 90 mm")
                      : fmt::format("{:.2f} mm rms, {:.1f}° rms{}", length, turn,
                                    ended ? "" : "; did not end with 0"),
           literal || (ended && length <= most_length && turn <= most_turn)},
          bounds));
    }
  }
  return figures;
}

}  // namespace pal::test
