// Jog in physics: it moves while orders come, and the arm is at rest soon after the last one.
#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "sim/cell/cell.hpp"
#include "skills_pal/jog/advance.hpp"
#include "tests/run/skills/support/physical_run.hpp"
#include "tests/support/built_skills.hpp"

namespace pal::test {
namespace {

using namespace std::chrono_literals;
using runtime::Time;
using runtime::drivers::PendantOrder;

constexpr double still = 0.1;  // deg/s of a joint: what friction and gravity leave of a joint that is held

// What is proved, of silence: jog.pal.
constexpr Time proved = 210ms;
// The last motion is answered within 6 ms of its request, begins 28 ms after the request, and takes 28 ms; then the
// arm settles.
constexpr Time made = 56ms, settles = 60ms;

struct Jogged {
  runtime::Outcome outcome;
  std::vector<sim::Sample> log;  // of the simulation's own truth
  Time begun{};
  Time last_order{};  // station time
};

/// From `from` on, every 50 ms, `times` times; then nothing, or a release.
Jogged jog(const std::string& scene_name, const std::vector<runtime::ParameterValue>& parameters,
           const PendantOrder& order, int times, bool release, std::uint64_t seed = 1, Time from = 250ms) {
  sim::CellOptions options;
  options.seed = seed;
  Jogged result;
  sim::Cell* place = nullptr;
  options.at_begin = [&](Time begin) {
    result.begun = begin;
    for (int i = 0; i <= times; ++i) {
      if (i == times && !release) break;
      PendantOrder next = order;
      next.held = i < times;
      const Time when = begin + from + i * 50ms;
      result.last_order = when;
      place->station().timeline().at(when, [place, next] { place->pendant().order(next); });
    }
  };
  sim::Cell cell(scene(scene_name), options);
  place = &cell;
  const auto skill = make_skill("jog");
  runtime::RunOptions run;
  run.costs = runtime::CostPolicy::random;
  run.seed = seed;
  result.outcome = cell.run(*skill, parameters, run);
  cell.rest(300ms);
  result.log = cell.workcell().log();
  return result;
}

/// The greatest speed of a joint from `from` on, deg/s.
double fastest(const Jogged& jogged, Time from) {
  double result = 0;
  const auto& log = jogged.log;
  for (std::size_t i = 1; i < log.size(); ++i) {
    if (log[i - 1].time < from) continue;
    const double seconds = std::chrono::duration<double>(log[i].time - log[i - 1].time).count();
    if (seconds > 0)
      result = std::max(result, sim::degrees((log[i].joints - log[i - 1].joints).cwiseAbs().maxCoeff()) / seconds);
  }
  return result;
}

/// When a joint was faster than `still` for the last time.
Time at_rest(const Jogged& jogged) {
  Time result{};
  const auto& log = jogged.log;
  for (std::size_t i = 1; i < log.size(); ++i) {
    const double seconds = std::chrono::duration<double>(log[i].time - log[i - 1].time).count();
    if (seconds > 0 &&
        sim::degrees((log[i].joints - log[i - 1].joints).cwiseAbs().maxCoeff()) / seconds > still)
      result = log[i].time;
  }
  return result;
}

Eigen::Vector3d way(const Jogged& jogged) {
  return 1e3 * (jogged.log.back().tool - jogged.log.front().tool);
}

double turned(const Jogged& jogged, Eigen::Index joint) {
  return sim::degrees(jogged.log.back().joints[joint] - jogged.log.front().joints[joint]);
}

}  // namespace

TEST_CASE("jog: the arm is at rest within the proved time after the last order, completion 1") {
  for (const double frame : {0.0, 1.0, 2.0})
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      // At the greatest speeds.
      const auto run = jog("nothing", {{"frame", frame}, {"speed", 100}, {"turn", 15}}, {{1, 0, 0, 0, 0, 0}}, 10,
                           false, seed);
      const auto after = at_rest(run) - run.last_order;
      CAPTURE(frame, seed, run.outcome.reason, after.count() * 1e-6);
      CHECK(end_of(run.outcome) == "jog 1");
      CHECK(fastest(run, run.begun) > 5);              // it moved
      CHECK(after > 150ms);                            // until it was told by silence
      CHECK(after <= proved + made + settles);
      CHECK(fastest(run, run.last_order + proved + made + settles) <= still);
    }
}

TEST_CASE("jog: in the joints one joint turns, and the others stay") {
  const auto run = jog("nothing", {{"frame", 0}, {"turn", 10}}, {{0, 0, 0, 0, 1, 0}}, 10, true);
  CAPTURE(run.outcome.reason);
  CHECK(end_of(run.outcome) == "jog 0");
  CHECK(turned(run, 4) > 3);
  for (const Eigen::Index other : {0, 1, 2, 3, 5}) CHECK(std::abs(turned(run, other)) < 0.15);
}

TEST_CASE("jog: along an axis of the world, and of the tool") {
  const auto up = jog("nothing", {{"frame", 1}, {"speed", 50}}, {{0, 0, 1, 0, 0, 0}}, 10, true);
  CAPTURE(up.outcome.reason, way(up).transpose());
  CHECK(end_of(up.outcome) == "jog 0");
  CHECK(way(up).z() > 15);
  CHECK(std::hypot(way(up).x(), way(up).y()) < 0.5);
  // The tool points down.
  const auto out = jog("nothing", {{"frame", 2}, {"speed", 50}}, {{0, 0, 1, 0, 0, 0}}, 10, true);
  CAPTURE(out.outcome.reason, way(out).transpose());
  CHECK(way(out).z() < -15);
}

TEST_CASE("jog: a step goes its way and ends by itself, completion 0") {
  const auto run = jog("nothing", {{"frame", 1}, {"speed", 50}, {"way", 10}}, {{-1, 0, 0, 0, 0, 0}}, 40, false);
  CAPTURE(run.outcome.reason, way(run).transpose());
  CHECK(end_of(run.outcome) == "jog 0");
  CHECK(way(run).x() == Approx(-10).margin(0.2));
  CHECK(run.outcome.duration < 2s);
  const auto turn = jog("nothing", {{"frame", 0}, {"angle", 5}, {"turn", 15}}, {{0, 0, 0, 0, 0, 1}}, 40, false);
  CHECK(turned(turn, 5) == Approx(5).margin(0.15));
}

TEST_CASE("jog: without an order nothing moves, completion 1") {
  const auto run = jog("nothing", {{"frame", 2}}, {}, 0, false);
  CHECK(end_of(run.outcome) == "jog 1");
  CHECK(fastest(run, run.begun) <= still);
}

TEST_CASE("jog: what is met stops it before the force is great, completion 2") {
  const auto run = jog("touch", {{"frame", 2}, {"speed", 20}, {"contact-force", 15}}, {{0, 0, 1, 0, 0, 0}}, 100, false);
  double peak = 0;
  for (const sim::Sample& sample : run.log) peak = std::max(peak, sample.contact_force);
  CAPTURE(run.outcome.reason, peak);
  CHECK(end_of(run.outcome) == "jog 2");
  CHECK(peak > 14);
  CHECK(peak < 15 + 0.1 * 20 * 11 + 6);  // 0.1 s of the way at 11 N/mm, and the sensor's noise
}

TEST_CASE("jog: a joint's limit is refused in words, completion 3") {
  const auto run = jog("nothing", {{"frame", 0}, {"turn", 15}}, {{0, 0, 0, 0, 1, 0}}, 400, false);
  CAPTURE(run.outcome.reason);
  CHECK(end_of(run.outcome) == "jog 3");
  CHECK(run.outcome.reason.find("joint 5") != std::string::npos);
  CHECK(fastest(run, run.log.back().time - 100ms) <= still);
}

TEST_CASE("jog: the next skill finds the port as it expects it") {
  sim::CellOptions options;
  sim::Cell* place = nullptr;
  options.at_begin = [&](Time begin) {
    for (int i = 0; i < 6; ++i)
      place->station().timeline().at(begin + 250ms + i * 50ms,
                                     [place] { place->pendant().order({{0, 0, 0, 0, 0, 1}}); });
  };
  sim::Cell cell(scene("touch"), options);
  place = &cell;
  const std::vector<runtime::ParameterValue> in_joints{{"frame", 0}};
  CHECK(cell.run(*make_skill("jog"), in_joints).code == 1);
  cell.rest(100ms);
  const auto touched = cell.run(*make_skill("touch"));
  CAPTURE(touched.reason);
  CHECK(touched.code == 0);
}

TEST_CASE("the ways of a step add up to it, and none is longer than it may be") {
  skills::JogAdvance advance;
  advance.start({1, 1, 1, 0.3, 0.3, 0.3}, {7, 7, 7, 0, 0, 0});
  double sum = 0, last = 0;
  int cycles = 0;
  while (!advance.there() && cycles < 100) {
    const double x = advance.next({-1, 0, 0, 0, 0, 0})[0];
    CHECK(x <= 0);
    CHECK(std::abs(x) <= 1 + 1e-9);
    CHECK(std::abs(x - last) <= 0.67);
    sum += x;
    last = x;
    ++cycles;
  }
  CHECK(sum == Approx(-7).margin(1e-9));
  CHECK(cycles < 15);
  CHECK(advance.next({-1, 0, 0, 0, 0, 0})[0] == 0);
}

TEST_CASE("a jog speeds up within three cycles, whatever the order asks for") {
  skills::JogAdvance advance;
  advance.start({1, 1, 1, 1, 1, 1}, {});
  CHECK(advance.next({5, 0, 0, 0, 0, 0})[0] == Approx(1.0 / 3));
  CHECK(advance.next({5, 0, 0, 0, 0, 0})[0] == Approx(2.0 / 3));
  CHECK(advance.next({5, 0, 0, 0, 0, 0})[0] == Approx(1));
  CHECK(advance.next({5, 0, 0, 0, 0, 0})[0] == Approx(1));
  CHECK(advance.next({-1, 0, 0, 0, 0, 0})[0] == Approx(2.0 / 3));
}

}  // namespace pal::test
