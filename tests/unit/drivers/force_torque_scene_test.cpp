// The force-torque sensor on the arm, above a plate.
#include <catch2/catch.hpp>
#include <cmath>

#include "runtime/drivers/force_torque/driver.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/devices/force_torque_emulator.hpp"
#include "tests/unit/drivers/physics.hpp"
#include "tests/unit/drivers/session.hpp"

namespace pal::sim {
namespace {

using namespace std::chrono_literals;

struct Cell {
  Cell()
      : sensor(timeline, wire.b(), [this] { return workcell.wrench(); },
               {.force_noise = 0, .torque_noise = 0}) {
    driver.prepare();
    while (!driver.ready()) run(1ms);
    REQUIRE(driver.trouble().empty());
    driver.attach(session);
    driver.open();
  }
  void run(runtime::Time time) { test::run(timeline, workcell, time); }
  // Moves the tool along its z axis by a distance in millimetres, and waits.
  void lower(double distance) {
    const int steps = 1 + static_cast<int>(std::abs(distance) / 0.3);
    for (int i = 0; i < steps; ++i) {
      REQUIRE_FALSE(workcell.move({0, 0, distance / steps, 0, 0, 0}, CorrectionFrame::tool, timeline.now()));
      run(alter_period);
    }
    run(300ms);
  }
  std::vector<double> read() {
    session.deliveries.clear();
    driver.receive(2, {});
    run(6ms);
    REQUIRE(session.deliveries.size() == 1);
    return session.deliveries[0].fields;
  }
  double contact() const { return workcell.log().back().contact_force; }

  runtime::drivers::Timeline timeline;
  runtime::drivers::Wire wire{timeline, {38400, 10}};
  Workcell workcell{find_scene("touch", {PAL_SCENE_DIR})};
  ForceTorqueEmulator sensor;
  runtime::drivers::ForceTorqueDriver driver{timeline, wire.a()};
  runtime::drivers::test::Session session{timeline, driver};
};

TEST_CASE(
    "force-torque sensor on the arm: the tool's weight is zero, pressing is as negative as the plate is hard",
    "[force-torque]") {
  Cell cell;
  const std::vector<double> free = cell.read();
  CHECK(std::abs(free[2]) <= 0.1);
  cell.lower(16);  // the plate is 15 mm below
  const std::vector<double> pressing = cell.read();
  CHECK(cell.contact() > 5);
  CHECK(pressing[2] == Approx(-cell.contact()).margin(0.11));  // half a step, and what changed within one
  CHECK(std::abs(pressing[0]) < 0.5);
  CHECK(std::abs(pressing[1]) < 0.5);
  CHECK(pressing.back() == 0);
  cell.lower(8);
  REQUIRE(cell.contact() > 66);
  const std::vector<double> overloaded = cell.read();
  CHECK(overloaded[2] == -65);
  CHECK(overloaded.back() == 1);
}

}  // namespace
}  // namespace pal::sim
