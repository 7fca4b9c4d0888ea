// Where the arm is, beside where it should be.
#include <fmt/format.h>

#include <algorithm>

#include "sim/arm/puma.hpp"
#include "sim/controller/motion_controller.hpp"
#include "sim/random.hpp"
#include "sim/workcell.hpp"
#include "tests/benchmark/workcell/row.hpp"

namespace pal::bench {
namespace {

using namespace std::chrono_literals;

double off_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& point) {
  const Eigen::Vector3d way = (to - from).normalized();
  return ((point - from) - way * way.dot(point - from)).norm();
}

struct Line {
  double off = 0;   // m, at most
  double rest = 0;  // m, 150 ms after the end
};

/// 316 mm at 0.25 m/s and 2 m/s^2.
Line straight_line(const sim::MachineOptions& machine) {
  sim::Workcell workcell(sim::find_scene("nothing", {PAL_SCENE_DIR}), {.machine = machine});
  const sim::Pose start = workcell.set_point();
  sim::Pose goal = start;
  goal.translation() += Eigen::Vector3d(0, 0.3, 0.1);
  if (const auto refused =
          workcell.motion().move_straight(goal, {.part = 1, .straight = 0.25}, workcell.now()))
    throw std::runtime_error("the line cannot be moved");
  Line line;
  const runtime::Time end = workcell.motion().planned_end(workcell.now());
  while (workcell.now() < end) {
    workcell.advance_to(workcell.now() + 1ms);
    line.off =
        std::max(line.off, off_line(start.translation(), goal.translation(), workcell.log().back().tool));
  }
  workcell.advance_to(end + 150ms);
  line.rest = (workcell.tool().translation() - goal.translation()).norm();
  return line;
}

/// Inverse, then forward, from joints drawn evenly over their ranges.
double worst_of_inverse(int poses) {
  sim::Random random(20260722, 0);
  const sim::Pose tool = Eigen::Translation3d(0.049, 0.01, 0.397) *
                         Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  double worst = 0;
  for (int i = 0; i < poses; ++i) {
    sim::Joints q;
    for (std::size_t j = 0; j < sim::joint_count; ++j)
      q[static_cast<Eigen::Index>(j)] =
          sim::puma_limits[j].lower + (sim::puma_limits[j].upper - sim::puma_limits[j].lower) * random.unit();
    const sim::Pose pose = sim::tool_pose(q, tool);
    const sim::InverseSolution solution = sim::inverse_tool(pose, tool, sim::configuration_of(q), q);
    if (solution.problem != sim::InverseProblem::none) throw std::runtime_error("a pose has no solution");
    worst =
        std::max(worst, (sim::tool_pose(solution.q, tool).matrix() - pose.matrix()).cwiseAbs().maxCoeff());
  }
  return worst;
}

std::string millimetres(double metres) {
  return fmt::format("{:.3f} mm", metres * 1e3);
}

}  // namespace

std::vector<Row> motion_rows() {
  const Line exact = straight_line(sim::MachineOptions::exact());
  const Line played = straight_line({});
  const double worst = worst_of_inverse(10'000);
  return {
      {"line at 0.25 m/s and 2 m/s^2, machine exact", millimetres(exact.off), "at most 0.15 mm",
       exact.off <= 0.15e-3},
      {"  the same, with counts and play", millimetres(played.off), "at most 0.15 mm", played.off <= 0.15e-3},
      {"150 ms after its end, machine exact", millimetres(exact.rest), "at most 0.05 mm",
       exact.rest <= 0.05e-3},
      {"  the same, with counts and play of 0.07 mm", millimetres(played.rest), "at most 0.12 mm",
       played.rest <= 0.12e-3},
      {"inverse then forward over 10,000 poses", fmt::format("{:.1e}", worst), "at most 1e-9",
       worst <= 1e-9}};
}

}  // namespace pal::bench
