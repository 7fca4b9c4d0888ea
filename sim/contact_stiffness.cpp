#include "sim/contact_stiffness.hpp"

#include <stdexcept>

#include "sim/workcell.hpp"

namespace pal::sim {
namespace {

constexpr double fine = 0.05;       // mm
constexpr double coarse = 1.0;      // mm
constexpr double far_enough = 400;  // mm
constexpr runtime::Time rest = std::chrono::milliseconds(100);

}  // namespace

double contact_stiffness(const Scene& scene, double low, double high) {
  Workcell workcell(scene);
  double depth = 0, count = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
  for (double force = 0; force < high;) {
    const bool touching = force > 0;
    const double step = touching ? fine : coarse;
    depth += step;
    if (depth > far_enough) throw std::runtime_error("nothing to press on within 400 mm of the start");
    if (const auto refused = workcell.move({0, 0, step, 0, 0, 0}, CorrectionFrame::tool, workcell.now()))
      throw std::runtime_error("pressing on the scene: " + *refused);
    workcell.advance_to(workcell.now() + alter_period + (touching ? rest : runtime::Time::zero()));
    force = workcell.log().back().contact_force;
    if (!touching || force < low || force > high) continue;
    ++count;
    sum_x += depth;
    sum_y += force;
    sum_xx += depth * depth;
    sum_xy += depth * force;
  }
  const double spread = count * sum_xx - sum_x * sum_x;
  if (count < 2 || spread <= 0)
    throw std::runtime_error("the contact is too stiff to measure between these forces");
  return (count * sum_xy - sum_x * sum_y) / spread;
}

}  // namespace pal::sim
