#include "sim/devices/alter_port.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;

namespace {

constexpr std::size_t tick_port = 0;
constexpr std::size_t correction_port = 1;

struct Cell {
  explicit Cell(AlterOptions options = {.phase = 5ms}) : port(workcell, std::move(options)) {
    port.attach(host);
  }

  // Answers each event after `delay` with `dz` mm.
  void answer(pal::runtime::Time delay, double dz) {
    host.on_delivery = [this, delay, dz](const Host::Delivery&) {
      host.at(host.now() + delay, [this, dz] {
        port.receive(correction_port, std::array<double, 6>{0, 0, dz, 0, 0, 0});
      });
    };
  }
  double height() const { return workcell.tool().translation().z() * 1e3; }

  Workcell workcell{scene("touch")};
  Host host{workcell};
  AlterPort port;
};

}  // namespace

TEST_CASE("alter: ports as the skills declare them") {
  const Cell cell;
  const auto& ports = cell.port.ports();
  REQUIRE(ports.size() == 2);
  CHECK(ports[0] == pal::runtime::PortSpec{"tick", false, {}});
  CHECK(ports[1] ==
        pal::runtime::PortSpec{
            "correction",
            true,
            {{"dx", "mm"}, {"dy", "mm"}, {"dz", "mm"}, {"rx", "deg"}, {"ry", "deg"}, {"rz", "deg"}}});
}

TEST_CASE("alter: an event at the phase after opening, then one every 28 ms") {
  Cell cell;
  cell.answer(1ms, 0);
  cell.host.run_until(10ms);
  CHECK(cell.host.deliveries.empty());
  cell.port.open();
  cell.host.run_until(100ms);
  REQUIRE(cell.host.deliveries.size() == 4);
  CHECK(cell.host.deliveries[0].time == 15ms);
  CHECK(cell.host.deliveries[0].port == tick_port);
  CHECK(cell.host.deliveries[3].time == 99ms);
  cell.port.close();
  cell.host.run_until(200ms);
  CHECK(cell.host.deliveries.size() == 4);
  CHECK(cell.host.faults.empty());
}

TEST_CASE("alter: the phase comes from the seed, within a period") {
  Workcell workcell(scene("touch"));
  pal::runtime::Time least = alter_period, most{};
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const AlterPort port(workcell, {.phase = std::nullopt, .seed = seed});
    least = std::min(least, port.phase());
    most = std::max(most, port.phase());
    CHECK(AlterPort(workcell, {.phase = std::nullopt, .seed = seed}).phase() == port.phase());
  }
  CHECK(least >= 0ms);
  CHECK(least < 2ms);  // 200 draws miss the first 2 of 28 ms with probability 4e-7
  CHECK(most <= 28ms);
  CHECK(most > 26ms);
}

TEST_CASE("alter: a correction is moved in the cycle after the one that it answers") {
  Cell cell;
  cell.answer(20ms - 1ns, 1.0);  // as late as may be
  const double start = cell.height();
  cell.port.open();
  cell.host.run_until(33ms);  // events at 5 and 33 ms
  CHECK(cell.height() == Approx(start).margin(0.005));
  cell.host.run_until(61ms);
  CHECK(start - cell.height() == Approx(1.0).margin(0.05));  // servos follow within 50 micrometres
  cell.host.run_until(33ms + 10 * 28ms);
  CHECK(start - cell.height() == Approx(10.0).margin(0.05));
  CHECK(cell.host.faults.empty());
}

TEST_CASE("alter: no answer in time stops the arm with a fault") {
  Cell cell;
  cell.answer(1ms, 1.0);
  cell.port.open();
  cell.host.run_until(80ms);  // the arm is moving
  cell.host.on_delivery = nullptr;
  cell.host.run_until(89ms + 20ms - 1ns);
  CHECK(cell.host.faults.empty());
  cell.host.run_until(89ms + 20ms);
  REQUIRE(cell.host.faults.size() == 1);
  CHECK(cell.host.faults[0] == "got no correction within 20.0 ms of its request");
  CHECK(cell.workcell.idle());
  const double there = cell.height();
  cell.host.run_until(400ms);
  CHECK(cell.height() == Approx(there).margin(0.05));
  CHECK(cell.host.faults.size() == 1);
}

TEST_CASE("alter: faults for an answer that nobody asked for and a motion that cannot be made") {
  SECTION("twice answered") {
    Cell cell;
    cell.port.open();
    cell.host.run_until(6ms);
    cell.port.receive(correction_port, std::array<double, 6>{});
    cell.port.receive(correction_port, std::array<double, 6>{});
    REQUIRE(cell.host.faults.size() == 1);
    CHECK(cell.host.faults[0] == "got a correction that it had not asked for");
  }
  SECTION("too fast") {
    Cell cell;
    cell.port.open();
    cell.host.run_until(6ms);
    cell.port.receive(correction_port, std::array<double, 6>{0, 0, 20, 0, 0, 0});
    REQUIRE(cell.host.faults.size() == 1);
    CHECK(cell.host.faults[0].find("cannot make the motion: the tool would move at 0.714 m/s") == 0);
    CHECK(cell.workcell.idle());
  }
}

TEST_CASE("alter: closed, the arm ends the motions that it has accepted and stands still") {
  Cell cell;
  cell.answer(1ms, 1.0);
  const double start = cell.height();
  cell.port.open();
  cell.host.run_until(35ms);  // events at 5 and 33 ms, both answered
  cell.port.close();
  cell.host.run_until(33ms + 2 * 28ms);
  CHECK(cell.workcell.idle());
  cell.host.run_until(300ms);
  CHECK(start - cell.height() == Approx(2.0).margin(0.1));  // encoders and play
}
