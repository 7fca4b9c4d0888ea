// The gripper's feedback: driver and emulator at the ends of a serial line, in virtual time.
#include <catch2/catch.hpp>
#include <string>

#include "runtime/drivers/gripper/driver.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/devices/gripper_emulator.hpp"
#include "tests/unit/drivers/session.hpp"

namespace pal::sim {
namespace {

using namespace std::chrono_literals;
using runtime::Time;
using runtime::drivers::GripperDriver;
using runtime::drivers::LineSpeed;
using runtime::drivers::Timeline;
using runtime::drivers::Wire;

constexpr std::size_t request_state = 0;
constexpr LineSpeed line{38400, 10};

const GripperEmulatorOptions quiet{.width_noise = 0, .force_noise = 0};

struct Cell {
  explicit Cell(GripperEmulatorOptions options = quiet)
      : gripper(
            timeline, wire.b(), [this] { return state; }, options) {
    session.begin();
  }
  const runtime::drivers::test::Session::Delivery& read() {
    const std::size_t before = session.deliveries.size();
    driver.receive(request_state, {});
    timeline.advance_to(timeline.now() + 9ms);
    REQUIRE(session.deliveries.size() == before + 1);
    return session.deliveries.back();
  }

  Timeline timeline;
  Wire wire{timeline, line};
  GripperState state{.width = 90, .force = 0, .holding = false};
  GripperEmulator gripper;
  GripperDriver driver{timeline, wire.a()};
  runtime::drivers::test::Session session{timeline, driver};
};

TEST_CASE("gripper: tells how wide it stands and how hard it presses", "[gripper]") {
  Cell cell;
  REQUIRE(cell.driver.trouble().empty());
  CHECK(cell.read().fields == std::vector<double>{90, 0, 0});
  cell.state = {.width = 50.02, .force = 19.9, .holding = true};
  CHECK(cell.read().fields == std::vector<double>{50.02, 19.9, 1});
  CHECK(cell.session.marks.size() == 4);
}

TEST_CASE("gripper: an answer keeps what its protocol says of its time", "[gripper]") {
  // "STATE" and its end are 6 bytes, "STATE 050.00 020.0 1" and its end 22.
  const GripperEmulatorOptions options;
  const Time bytes = line.duration(6 + 22);
  const Time shortest = bytes + options.shortest_wait;
  const Time longest = bytes + options.longest_wait;
  REQUIRE(shortest >= 8200us);  // ON REQUEST 8.2 TO 8.8 ms
  REQUIRE(longest <= 8800us);
  Cell cell{options};
  Time least = 1s, most{};
  for (int i = 0; i < 300; ++i) {
    const Time asked = cell.timeline.now();
    const Time took = cell.read().time - asked;
    least = std::min(least, took);
    most = std::max(most, took);
  }
  INFO("measured " << least.count() << " to " << most.count() << " ns");
  CHECK(least >= shortest - 2ns);
  CHECK(least < shortest + 10us);
  CHECK(most <= longest + 2ns);
  CHECK(most > longest - 10us);
}

TEST_CASE("gripper: requests wait for each other, and one may be withdrawn", "[gripper]") {
  Cell cell;
  for (int i = 0; i < 3; ++i) cell.driver.receive(request_state, {});
  CHECK(cell.driver.withdraw(request_state));
  cell.timeline.advance_to(cell.timeline.now() + 40ms);
  CHECK(cell.session.deliveries.size() == 2);
  CHECK_FALSE(cell.driver.withdraw(request_state));
}

TEST_CASE("gripper: what goes wrong on the line ends the skill, in words", "[gripper]") {
  Cell cell;
  std::string expected;
  cell.driver.receive(request_state, {});
  SECTION("unplugged") {
    cell.wire.cut("unplugged");
    expected = "the link is broken: unplugged";
  }
  SECTION("garbled") {
    cell.wire.tamper([](runtime::drivers::Carrier::Direction direction, std::vector<std::uint8_t>& bytes) {
      if (direction == runtime::drivers::Carrier::Direction::to_a) bytes[8] = 'x';
    });
    expected = "answers \"STATE 09x.00 000.0 0\" to STATE";
  }
  SECTION("short") {
    cell.wire.tamper([](runtime::drivers::Carrier::Direction direction, std::vector<std::uint8_t>& bytes) {
      if (direction == runtime::drivers::Carrier::Direction::to_a) bytes.resize(9);
    });
    expected =
        "only \"STATE 090\" came of an answer within 50 ms; is it switched on, and is its cable plugged in?";
  }
  SECTION("late") {
    cell.gripper.slow_down(60ms);
    cell.timeline.advance_to(cell.timeline.now() + 9ms);  // the first one was drawn already
    cell.session.deliveries.clear();
    cell.driver.receive(request_state, {});
    expected = "no answer to STATE came within 50 ms; is it switched on, and is its cable plugged in?";
  }
  cell.timeline.advance_to(cell.timeline.now() + 55ms);
  CHECK(cell.session.faults == std::vector<std::string>{expected});
  CHECK(cell.session.deliveries.empty());

  cell.driver.close();
  cell.wire.mend();
  cell.wire.tamper(nullptr);
  cell.gripper.slow_down(0ms);
  cell.timeline.advance_to(cell.timeline.now() + 100ms);
  cell.session.begin();
  CHECK(cell.driver.trouble().empty());
  cell.read();
}

}  // namespace
}  // namespace pal::sim
