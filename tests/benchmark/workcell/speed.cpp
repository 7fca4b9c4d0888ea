// Physics alone against physics with servos, devices and a skill that runs. Both have the same model in free
// air, and take turns.
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <chrono>

#include "programs/workcell/session/session.hpp"
#include "sim/model/mujoco_physics.hpp"
#include "tests/benchmark/workcell/clock.hpp"
#include "tests/benchmark/workcell/row.hpp"
#include "tests/support/built_skills.hpp"

namespace pal::bench {
namespace {

sim::Scene free_air() {
  return sim::find_scene("nothing", {PAL_SCENE_DIR});
}

constexpr double way = 220;  // mm down, and back: the nearer the table, the more shapes MuJoCo looks at

/// Steps a second of CPU, with the drives at what holds the arm, a third each at begin, middle and end of the
/// way.
double bare(int steps) {
  double seconds = 0;
  for (const double down : {0.0, way / 2, way}) {
    sim::Workcell workcell(free_air(), {.raise = -down});
    sim::Physics& physics = workcell.physics();
    const double begin = cpu_seconds();
    for (int i = 0; i < steps / 3; ++i) mj_step(&physics.model(), &physics.data());
    seconds += cpu_seconds() - begin;
  }
  return steps / seconds;
}

struct Cost {
  double steps = 0, seconds = 0;
};

Cost session(double reach) {
  const auto skill = test::make_skill("touch");
  workcell::Session session;
  session.scene = free_air();
  session.parameters = {{"reach", reach}, {"approach-speed", 20}};
  const double begin = cpu_seconds();
  const workcell::SessionResult result = workcell::run_session(*skill, session);
  return {static_cast<double>(result.log.size()), cpu_seconds() - begin};
}

/// Steps a second of CPU while a skill runs. A short run is taken off a long one, so that loading and
/// settling do not count.
double running() {
  const Cost small = session(20), large = session(way);
  return (large.steps - small.steps) / (large.seconds - small.seconds);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

std::vector<Row> speed_rows() {
  constexpr int rounds = 7, steps = 20'000;
  std::vector<double> bares, runnings, ratios;
  for (int round = 0; round < rounds; ++round) {
    bares.push_back(bare(steps));
    runnings.push_back(running());
    ratios.push_back(runnings.back() / bares.back());
  }
  const double ratio = median(ratios);
  return {{"steps a second, bare mj_step", fmt::format("{:.0f}", median(bares)), "", true},
          {"steps a second, servos, devices and a running skill", fmt::format("{:.0f}", median(runnings)), "",
           true},
          {"  the second by the first", fmt::format("{:.1f} %", 100 * ratio), "at least 90 %", ratio >= 0.9}};
}

}  // namespace pal::bench
