#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/run/skills/bench/table.hpp"
#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/proved_bounds.hpp"

namespace pal::test {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// The surface of sim/scenes/seam.scene with the settings that it leaves out; mm in frame 0.
class Seam {
 public:
  Seam() {
    for (double x = -150; x <= 150; x += 0.5) highest_ = std::max(highest_, ridge(x));
  }
  Eigen::Vector3d edge(double x) const {
    return {x, middle_y + seam(x - middle_x), top + ridge(x - middle_x) - highest_};
  }
  Eigen::Vector3d along(double x) const { return (edge(x + 0.01) - edge(x - 0.01)).normalized(); }
  /// Out of the surface on the side of greater y, which is the tool's smaller y.
  Eigen::Vector3d normal(double x) const {
    const double bend = (seam(x - middle_x + 0.01) - seam(x - middle_x - 0.01)) / 0.02;
    const double rise = (ridge(x - middle_x + 0.01) - ridge(x - middle_x - 0.01)) / 0.02;
    return Eigen::Vector3d(-(rise + fall() * bend), fall(), 1).normalized();
  }

 private:
  static constexpr double middle_x = 500, middle_y = -200, top = -181.8 + 40;
  static constexpr double height = 8, length = 200, swing = 10;
  static double fall() { return std::tan(15 * degree); }
  static double ridge(double x) { return height / 2 * std::sin(2 * std::numbers::pi * x / length); }
  static double seam(double x) { return swing * std::sin(2 * std::numbers::pi * x / (1.7 * length)); }
  double highest_ = -1e9;
};

struct Off {
  double length = 0;  // mm, of the edge from where it should be, in the tool's y-z plane
  double turn = 0;    // deg
};

Off off(const Seam& seam, const sim::Sample& sample, double standoff) {
  const Eigen::Vector3d tip = sample.tool * 1e3;
  const Eigen::Matrix3d tool = sample.tool_turn.toRotationMatrix();
  double x = tip.x();
  for (int i = 0; i < 20; ++i) x -= (seam.edge(x) - tip).dot(tool.col(0)) / seam.along(x).dot(tool.col(0));
  const Eigen::Vector3d seen = tool.transpose() * (seam.edge(x) - tip);
  Eigen::Matrix3d wanted;
  const Eigen::Vector3d depth = -seam.normal(x);
  wanted << seam.along(x), depth.cross(seam.along(x)), depth;
  return {std::hypot(seen.y(), seen.z() - standoff),
          Eigen::AngleAxisd(Eigen::Matrix3d(tool.transpose() * wanted)).angle() / degree};
}

}  // namespace

std::vector<Figure> measure_follow_edge() {
  const Seam seam;
  constexpr double standoff = 200,
                   settled = 90;  // mm; the first of the way is spent on leaning by 15 degrees
  std::vector<Figure> figures;
  struct Law {
    const char* scene;
    bool literal;
  };
  for (const auto& [scene, literal] :
       {Law{"seam-crease", false}, Law{"seam-step", false}, Law{"seam-step", true}}) {
    for (const double speed : {10.0, 30.0}) {
      ProvedBounds bounds("follow-edge");
      double lengths = 0, turns = 0, count = 0;
      bool ended = true;
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const auto result = run({.skill = "follow-edge",
                                 .scene = scene,
                                 .parameters = {{"track", speed * 0.028},
                                                {"distance", 20},
                                                {"translation", literal ? 0.5 : 3},
                                                {"rotation", literal ? 0.5 : 1},
                                                {"standoff", standoff / 10},
                                                {"literal", literal ? 1.0 : 0.0}},
                                 .seed = seed});
        bounds.observe(result.outcome.trace);
        ended = ended && result.outcome.code == 0 && result.outcome.overruns == 0;
        const double start = result.log.front().tool.x();
        for (const sim::Sample& sample : result.log) {
          if (sample.time > result.outcome.duration || (sample.tool.x() - start) * 1e3 < settled) continue;
          const Off now = off(seam, sample, standoff);
          lengths += now.length * now.length;
          turns += now.turn * now.turn;
          ++count;
        }
      }
      const double length = std::sqrt(lengths / count), turn = std::sqrt(turns / count);
      const double most_length = speed <= 10 ? 0.25 : 0.4, most_turn = speed <= 10 ? 2.5 : 3.5;
      figures.push_back(
          {"follow-edge",
           fmt::format("{}, {} mm/s, scene {}, seeds 1 to 3",
                       literal ? "the thesis's law" : "by the map of the edge", speed, scene),
           literal ? "reported" : fmt::format("<= {} mm rms, <= {}° rms", most_length, most_turn),
           count == 0 ? std::string("the edge is lost in the first 90 mm")
                      : fmt::format("{:.2f} mm rms, {:.1f}° rms{}", length, turn,
                                    ended ? "" : "; did not end with 0"),
           literal || (ended && length <= most_length && turn <= most_turn), bounds.greatest_part()});
    }
  }
  return figures;
}

}  // namespace pal::test
