#include "sim/workcell.hpp"

#include <catch2/catch.hpp>
#include <ctime>

#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;

namespace {

// Without encoders and play, whose effects machine_test.cpp looks at.
const WorkcellOptions exact{.machine = MachineOptions::exact()};

}  // namespace

TEST_CASE("the arm stands where it is told, against gravity and friction") {
  Workcell workcell(scene("touch"), exact);
  workcell.advance_to(1s);
  CHECK((workcell.tool().translation() - workcell.set_point().translation()).norm() < 1e-6);
  CHECK(workcell.now() == 1s);
  CHECK(workcell.log().size() == 1000);
  CHECK(workcell.log().back().time == 1s);
}

TEST_CASE("the arm follows straight lines within a tenth of a millimetre") {
  Workcell workcell(scene("nothing"), exact);
  const Pose start = workcell.tool();
  double worst = 0;
  for (int i = 0; i < 40; ++i) {  // 60 mm/s along y, then stop
    const double step = i < 30 ? 1.68 : 0;
    REQUIRE_FALSE(workcell.move({0, step, 0, 0, 0, 0}, CorrectionFrame::world, workcell.now()));
    workcell.advance_to(workcell.now() + alter_period);
    worst = std::max(worst, (workcell.tool().translation() - workcell.set_point().translation()).norm());
  }
  CHECK(worst < 1e-4);
  CHECK((workcell.tool().translation() - start.translation() - Eigen::Vector3d(0, 0.0504, 0)).norm() < 1e-5);
  CHECK(workcell.tool().linear().isApprox(start.linear(), 1e-4));
}

TEST_CASE("physics advances in whole milliseconds, whatever the calls") {
  Workcell one(scene("touch")), many(scene("touch"));
  one.move({0, 0, 1, 0, 0, 0}, CorrectionFrame::tool, 0ms);
  many.move({0, 0, 1, 0, 0, 0}, CorrectionFrame::tool, 0ms);
  one.advance_to(40ms);
  for (pal::runtime::Time t{}; t <= 40ms; t += 137us) many.advance_to(t);
  many.advance_to(40ms);
  REQUIRE(one.log().size() == many.log().size());
  for (std::size_t i = 0; i < one.log().size(); ++i) REQUIRE(one.log()[i].tool == many.log()[i].tool);
  one.advance_to(40ms + 999us);
  CHECK(one.now() == 40ms);
}

TEST_CASE("a cell that rests takes no processor, and moves as before when it is told to") {
  for (const char* name : {"touch", "parts", "sponge"}) {
    INFO(name);
    Workcell rests(scene(name), {.keep_log = false}), steps(scene(name), {.keep_log = false});
    std::size_t samples = 0;
    const auto listener = rests.on_sample([&samples](const Sample&) { ++samples; });
    rests.let_rest(true);
    const std::clock_t begin = std::clock();
    rests.advance_to(300s);
    // Each step of physics takes some 50 us: all 300,000 of them 15 s.
    CHECK(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC < 3);
    CHECK(samples == 300'000);
    rests.let_rest(false);
    steps.advance_to(10s);
    CHECK((rests.tool().translation() - steps.tool().translation()).norm() < 1e-7);
    CHECK((rests.wrench().force - steps.wrench().force).norm() < 0.01);
    rests.let_rest(true);
    for (Workcell* each : {&rests, &steps}) {
      REQUIRE_FALSE(each->move({0, 0, 1, 0, 0, 0}, CorrectionFrame::tool, each->now()));
      each->advance_to(each->now() + 1s);
    }
    CHECK((rests.tool().translation() - steps.tool().translation()).norm() < 2e-5);
    CHECK((rests.tool().translation() - rests.set_point().translation()).norm() < 2e-4);
  }
}

TEST_CASE("a start that is raised is raised by that much") {
  Workcell low(scene("touch"), exact);
  Workcell high(scene("touch"), {.raise = 2.5, .machine = MachineOptions::exact()});
  const Eigen::Vector3d lift = high.tool().translation() - low.tool().translation();
  CHECK((lift - Eigen::Vector3d(0, 0, 2.5e-3)).norm() < 1e-6);
}

TEST_CASE("pressing on the plate is steady, and as stiff as pad and contact together") {
  Workcell workcell(scene("touch"));
  const auto press = [&](double distance) {
    const int steps = 1 + static_cast<int>(distance / 0.5);
    for (int i = 0; i < steps; ++i) {
      REQUIRE_FALSE(workcell.move({0, 0, distance / steps, 0, 0, 0}, CorrectionFrame::tool, workcell.now()));
      workcell.advance_to(workcell.now() + alter_period);
    }
    workcell.advance_to(workcell.now() + 500ms);
    return workcell.log().back().contact_force;
  };
  const double first = press(16);
  const double second = press(1);
  const double stiffness = second - first;  // N/mm
  CHECK(workcell.pad_stiffness() == 20000);
  // In series with the contact's own softness: less than the pad alone, more than a third of it.
  CHECK(stiffness < 20);
  CHECK(stiffness > 7);
  // Standing still the force stays within the noise of the device.
  double least = 1e9, most = 0;
  workcell.advance_to(workcell.now() + 500ms);
  for (std::size_t i = workcell.log().size() - 400; i < workcell.log().size(); ++i) {
    least = std::min(least, workcell.log()[i].contact_force);
    most = std::max(most, workcell.log()[i].contact_force);
  }
  CHECK(most - least < 0.05);
}

TEST_CASE("one seed of the machine gives one run, bit for bit") {
  const auto run = [](const char* name, const MachineOptions& machine) {
    Workcell workcell(scene(name), {.machine = machine});
    for (int i = 0; i < 12; ++i) {
      workcell.move({0.2, 0, 0.5, 0, 0, 0.1}, CorrectionFrame::tool, workcell.now());
      workcell.advance_to(workcell.now() + alter_period);
    }
    return workcell.log();
  };
  for (const char* name : {"touch", "parts", "waves"}) {
    const auto one = run(name, {}), again = run(name, {}), other = run(name, {.seed = 2});
    REQUIRE(one.size() == again.size());
    bool same = true;
    for (std::size_t i = 0; i < one.size(); ++i)
      same = same && one[i].joints == again[i].joints && one[i].contact_force == again[i].contact_force &&
             one[i].wrench.force == again[i].wrench.force;
    CAPTURE(name);
    CHECK(same);
    CHECK(one.back().joints != other.back().joints);
    CHECK((one.back().tool - other.back().tool).norm() < 3e-4);
  }
}

TEST_CASE("encoders show whole counts, and the log has what a plot needs") {
  Workcell workcell(scene("touch"));
  workcell.advance_to(50ms);
  const Joints shown = workcell.encoder_joints();
  CHECK((shown - workcell.joints()).cwiseAbs().maxCoeff() > 0);
  CHECK((shown - workcell.joints()).cwiseAbs().maxCoeff() < 2e-4);  // a count and half of the play
  const Sample& sample = workcell.log().back();
  CHECK(sample.joints == workcell.joints());
  CHECK((sample.tool - workcell.tool().translation()).norm() == 0);
  CHECK((sample.set_point - workcell.set_point().translation()).norm() == 0);
  CHECK(sample.tool_turn.toRotationMatrix().isApprox(workcell.tool().linear(), 1e-12));
  CHECK(sample.wrench.force == workcell.wrench().force);
  // Looking does not move anything.
  CHECK(workcell.encoder_joints() == shown);
}
