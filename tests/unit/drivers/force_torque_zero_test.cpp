// The force-torque sensor's zero: taken once in free air, kept under load, in every pose.
#include <catch2/catch.hpp>
#include <optional>
#include <string>

#include "runtime/drivers/force_torque/driver.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/devices/force_torque_emulator.hpp"
#include "tests/unit/drivers/session.hpp"

namespace pal::sim {
namespace {

using namespace std::chrono_literals;
using runtime::drivers::ForceTorqueDriver;

/// A sensor whose gauges show something under no load, with a tool of 2 N.
struct Bench {
  explicit Bench(ForceTorqueEmulatorOptions with = {}) : options(with) {
    options.force_noise = options.torque_noise = 0;
    driver_options.tool_weight = [this] { return weight; };
  }
  // Brings the sensor to where a skill may begin; the skill then reads it once.
  double read_along_z() {
    runtime::test::Session session{timeline, driver()};
    session.begin();
    if (!driver().trouble().empty()) return -1e9;
    driver().receive(0, {});
    timeline.advance_to(timeline.now() + 6ms);
    REQUIRE(session.deliveries.size() == 1);
    driver().close();
    return session.deliveries[0].fields[2];
  }
  ForceTorqueDriver& driver() {
    if (!driver_) driver_.emplace(timeline, wire.a(), driver_options);
    return *driver_;
  }

  ForceTorqueEmulatorOptions options{.most_offset = 1.5, .most_torque_offset = 0.08};
  runtime::drivers::ForceTorqueDriverOptions driver_options;
  runtime::drivers::Timeline timeline;
  runtime::drivers::Wire wire{timeline, {38400, 10}};
  Wrench load{{0, 0, 2}, {0, 0, 0}};
  runtime::drivers::force_torque::Load weight{0, 0, 2, 0, 0, 0};
  ForceTorqueEmulator sensor{timeline, wire.b(), [this] { return load; }, options};
  std::optional<ForceTorqueDriver> driver_;
};

const ForceTorqueEmulatorOptions gauges{.most_offset = 1.5, .most_torque_offset = 0.08};

TEST_CASE("force-torque zero: a tool that presses when the next skill begins still presses",
          "[force-torque]") {
  Bench bench(gauges);
  CHECK(bench.read_along_z() == Approx(0).margin(0.11));
  for (const double pressing : {12.0, 5.0, 15.8}) {
    bench.load.force.z() = 2 - pressing;
    CHECK(bench.read_along_z() == Approx(-pressing).margin(0.11));
  }
}

TEST_CASE("force-torque zero: the tool's weight is taken out in every pose", "[force-torque]") {
  Bench bench(gauges);
  bench.read_along_z();
  bench.load = {{2, 0, 0}, {0, 0, 0}};
  bench.weight = {2, 0, 0, 0, 0, 0};
  CHECK(bench.read_along_z() == Approx(0).margin(0.11));
}

TEST_CASE("force-torque zero: without one, a tool that touches is refused until it is free",
          "[force-torque]") {
  Bench bench(gauges);
  bench.load.force.z() = 2 - 14.2;
  CHECK(bench.read_along_z() == -1e9);
  CHECK(bench.driver().trouble().find("it has no zero yet, and shows -1") == 0);
  CHECK(bench.driver().trouble().find("move the tool into free air") != std::string::npos);
  bench.load.force.z() = 2;
  CHECK(bench.read_along_z() == Approx(0).margin(0.11));
}

TEST_CASE("force-torque zero: it is kept when the sensor was off meanwhile", "[force-torque]") {
  Bench bench(gauges);
  bench.read_along_z();
  bench.wire.b().write(
      runtime::drivers::as_bytes("oops"));  // trouble: the next skill starts the sensor again
  bench.timeline.advance_to(bench.timeline.now() + 100ms);
  REQUIRE_FALSE(bench.driver().trouble().empty());
  bench.load.force.z() = 2 - 9;
  CHECK(bench.read_along_z() == Approx(-9).margin(0.11));
  bench.wire.a().write(runtime::drivers::as_bytes("\x17"));  // the same, and nobody was told
  bench.timeline.advance_to(bench.timeline.now() + 1ms);
  bench.driver().close();
  CHECK(bench.read_along_z() == Approx(-9).margin(0.11));
}

TEST_CASE("force-torque zero: it follows what the gauges drift by, no further than a sensor in order drifts",
          "[force-torque]") {
  Bench bench(gauges);
  bench.read_along_z();
  double drifted = 0;
  for (; drifted < 1.2; drifted += 0.1) {
    bench.load.force.z() = 2 + drifted;
    bench.read_along_z();
    CHECK(bench.driver().trouble().empty());
    CHECK(std::abs(bench.read_along_z()) <= 0.1);
  }
  for (; drifted < 3 && bench.driver().trouble().empty(); drifted += 0.1) {
    bench.load.force.z() = 2 + drifted;
    bench.read_along_z();
  }
  CHECK(drifted < 2);
  CHECK(bench.driver().trouble().find("its zero has drifted by 1.5 N along z") == 0);
}

}  // namespace
}  // namespace pal::sim
