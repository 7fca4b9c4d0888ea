// The force-torque sensor: its driver and its emulator at the ends of a serial line, in virtual time.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "runtime/drivers/force_torque/driver.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/devices/force_torque_emulator.hpp"
#include "tests/unit/drivers/session.hpp"

namespace pal::sim {
namespace {

using namespace std::chrono_literals;
using runtime::Time;
using runtime::drivers::ForceTorqueDriver;
using runtime::drivers::LineSpeed;
using runtime::drivers::Timeline;
using runtime::drivers::Wire;
using Direction = runtime::drivers::Carrier::Direction;

constexpr std::size_t request_wrench = 0;
constexpr std::size_t wrench = 1;
constexpr std::size_t request_record = 2;
constexpr std::size_t record = 3;

const ForceTorqueEmulatorOptions quiet{.force_noise = 0, .torque_noise = 0};

/// The sensor on a bench, with a person at its terminal.
struct Bench {
  explicit Bench(ForceTorqueEmulatorOptions options = quiet)
      : sensor(
            timeline, wire.b(), [this] { return load; }, options) {}

  Timeline timeline;
  Wire wire{timeline, {38400, 10}};
  Wrench load;
  ForceTorqueEmulator sensor;
};

struct Terminal final : runtime::drivers::LinkUser {
  explicit Terminal(Bench& used) : bench(used) {
    bench.wire.a().connect(this);
    bench.timeline.advance_to(100ms);
  }
  ~Terminal() override { bench.wire.a().connect(nullptr); }
  /// Types a text, and gives back all that comes within `wait`.
  std::string type(std::string_view text, Time wait = 100ms) {
    seen.clear();
    bench.wire.a().write(runtime::drivers::as_bytes(text));
    bench.timeline.advance_to(bench.timeline.now() + wait);
    return seen;
  }
  void on_bytes(runtime::drivers::Bytes bytes) override { seen += runtime::drivers::as_text(bytes); }
  void on_break(std::string_view) override {}
  Bench& bench;
  std::string seen;
};

struct Cell : Bench {
  explicit Cell(ForceTorqueEmulatorOptions options = quiet) : Bench(options) { session.begin(); }

  const runtime::drivers::test::Session::Delivery& read(std::size_t request = request_wrench) {
    const std::size_t before = session.deliveries.size();
    driver.receive(request, {});
    timeline.advance_to(timeline.now() + 6ms);
    REQUIRE(session.faults == std::vector<std::string>{});
    REQUIRE(session.deliveries.size() == before + 1);
    return session.deliveries.back();
  }

  ForceTorqueDriver driver{timeline, wire.a()};
  runtime::drivers::test::Session session{timeline, driver};
};

TEST_CASE("force-torque sensor: answers a person at a terminal", "[force-torque]") {
  Bench bench;
  Terminal terminal(bench);
  CHECK(terminal.seen == "\r\nF/T sensor, 65 N, 5 N*m\r\n>");
  bench.load = {{1, -2, 3.06}, {0.3, 0, -0.003}};
  CHECK(terminal.type("QR\r") == "QR\r\n0,    20,   -40,    62,   100,     0,    -1\r\n\r\n>");
  CHECK(terminal.type("CV 5\r") == "CV 5\r\r\n>");
  CHECK(terminal.type("\x14") ==
        "\x14"
        "0,    20,    62\r\n");
  CHECK(terminal.type("CD B\r") == "CD B\r\r\n>");
  CHECK(terminal.type("\x14") == std::string("\x14\0\0\x14\0\x3e", 6));
  CHECK(terminal.type("CV 0\r") == "CV 0\r\n? CV 0\r\n>");
  CHECK(terminal.type("HELLO\r") == "HELLO\r\n? HELLO\r\n>");
  CHECK(terminal.type("\r") == "\r\r\n>");
  CHECK(terminal.type("\x17") == "\r\nF/T sensor, 65 N, 5 N*m\r\n>");
  CHECK(terminal.type("\x14") ==
        "\x14"
        "0,    20,   -40,    62,   100,     0,    -1\r\n");
}

TEST_CASE("force-torque sensor: a bias is taken off, and given back", "[force-torque]") {
  Bench bench;
  Terminal terminal(bench);
  terminal.type("CV 1\r");
  bench.load.force.x() = 10;
  CHECK(terminal.type("SB\r") == "SB\r\r\n>");
  CHECK(terminal.type("\x14") ==
        "\x14"
        "0,     0\r\n");
  bench.load.force.x() = 12;
  CHECK(terminal.type("\x14") ==
        "\x14"
        "0,    40\r\n");
  terminal.type("SB\r");
  CHECK(terminal.type("\x14") ==
        "\x14"
        "0,     0\r\n");
  terminal.type("SU\r");
  CHECK(terminal.type("\x14") ==
        "\x14"
        "0,    40\r\n");
  terminal.type("SB\r");
  terminal.type("SZ\r");
  CHECK(terminal.type("\x14") ==
        "\x14"
        "0,   240\r\n");
}

TEST_CASE("force-torque sensor: streams until a line ends", "[force-torque]") {
  Bench bench;
  Terminal terminal(bench);
  terminal.type("CV 1\r");
  const std::string seen = terminal.type("QS\r", 50ms);
  // A record of 10 characters takes 2.6 ms, and 1.8 to 2.1 ms of conversion.
  const std::size_t records = static_cast<std::size_t>(std::count(seen.begin(), seen.end(), ','));
  CHECK(records >= 9);
  CHECK(records <= 11);
  CHECK(terminal.type(" \r").ends_with("0,     0\r\n\r\r\n>"));
  CHECK(terminal.type("", 50ms).empty());
}

TEST_CASE("force-torque driver: a record keeps what its protocol says of its time", "[force-torque]") {
  // Request, echo and record are 1 + 1 + 13 bytes; the conversion lies between the echo and the record.
  const Time bytes = LineSpeed{38400, 10}.duration(15);
  const ForceTorqueEmulatorOptions options;
  const Time shortest = bytes + options.shortest_conversion;
  const Time longest = bytes + options.longest_conversion;
  REQUIRE(bytes == 3906250ns);
  REQUIRE(shortest >= 5700us);  // what skills_pal/workcell.pal says of this device
  REQUIRE(longest <= 6ms);

  Cell cell{options};
  Time least = 1s, most{};
  for (int i = 0; i < 500; ++i) {
    const Time asked = cell.timeline.now();
    const Time took = cell.read().time - asked;
    least = std::min(least, took);
    most = std::max(most, took);
  }
  INFO("measured " << least.count() << " to " << most.count() << " ns");
  CHECK(least >= shortest - 2ns);  // each of three parcels is rounded to a nanosecond
  CHECK(least < shortest + 10us);
  CHECK(most <= longest + 2ns);
  CHECK(most > longest - 10us);
}

TEST_CASE("force-torque driver: the load at the first start is zero, and pressing is negative",
          "[force-torque]") {
  Bench bench;
  bench.load.force.z() = 1.3;  // the tool's weight
  ForceTorqueDriver driver{bench.timeline, bench.wire.a()};
  runtime::drivers::test::Session session{bench.timeline, driver};
  session.begin();
  REQUIRE(driver.trouble().empty());
  bench.load.force.z() = 1.3 - 12;
  driver.receive(request_wrench, {});
  bench.timeline.advance_to(bench.timeline.now() + 6ms);
  REQUIRE(session.deliveries.size() == 1);
  CHECK(session.deliveries[0].port == wrench);
  CHECK(session.deliveries[0].fields == std::vector<double>{0, 0, -12, 0, 0, 0});
}

TEST_CASE("force-torque driver: steps of 0.05 N, along z of 0.10 N, of 0.003 N*m about", "[force-torque]") {
  Cell cell;
  cell.load = {{1.03, -1.03, 1.03}, {0.1, 0.1, 0.1}};
  const std::vector<double> fields = cell.read().fields;
  CHECK(fields[0] == Approx(1.05));
  CHECK(fields[1] == Approx(-1.05));
  CHECK(fields[2] == Approx(1.0));
  CHECK(fields[3] == Approx(33 / 333.33));
}

TEST_CASE("force-torque driver: noise of the stated deviation, the same for the same seed",
          "[force-torque]") {
  const ForceTorqueEmulatorOptions options{.seed = 7};
  Cell cell{options}, again{options};
  double sum = 0, squares = 0;
  const int count = 400;
  for (int i = 0; i < count; ++i) {
    const std::vector<double> fields = cell.read().fields;
    REQUIRE(again.read().fields == fields);
    sum += fields[0];
    squares += fields[0] * fields[0];
  }
  // 0.05 N, steps of 0.05 N (deviation 0.05 / sqrt(12)), and a bias of 16 conversions: 0.054 N.
  CHECK(std::abs(sum / count) < 0.05);
  CHECK(std::sqrt(squares / count) == Approx(0.054).epsilon(0.2));
}

TEST_CASE("force-torque driver: an overload is a flag, no fault", "[force-torque]") {
  Cell cell;
  CHECK(cell.read(request_record).fields.back() == 0);
  cell.load.force.z() = -80;
  const auto overloaded = cell.read(request_record);
  CHECK(overloaded.port == record);
  CHECK(overloaded.fields == std::vector<double>{0, 0, -65, 0, 0, 0, 1});
  CHECK(cell.read(request_wrench).fields == std::vector<double>{0, 0, -65, 0, 0, 0});
  cell.load.force.z() = 0;
  cell.load.torque.y() = 5.2;
  CHECK(cell.read(request_record).fields.back() == 1);
  CHECK(cell.session.deliveries.back().fields[4] == Approx(5).margin(0.002));
}

TEST_CASE("force-torque driver: requests wait for each other, and one may be withdrawn", "[force-torque]") {
  Cell cell;
  cell.driver.receive(request_wrench, {});
  cell.driver.receive(request_record, {});
  cell.driver.receive(request_wrench, {});
  CHECK_FALSE(cell.driver.withdraw(record));
  CHECK(cell.driver.withdraw(request_wrench));        // the one that waits
  CHECK_FALSE(cell.driver.withdraw(request_wrench));  // the other is being served
  cell.timeline.advance_to(cell.timeline.now() + 20ms);
  REQUIRE(cell.session.deliveries.size() == 2);
  CHECK(cell.session.deliveries[0].port == wrench);
  CHECK(cell.session.deliveries[1].port == record);
  CHECK(cell.session.marks.size() == 4);
}

TEST_CASE("force-torque driver: a session that ends leaves no answer to the next", "[force-torque]") {
  Cell cell;
  cell.load.force.x() = 3.1;  // 62 counts: a record that holds the prompt's character
  cell.driver.receive(request_wrench, {});
  cell.driver.close();
  runtime::drivers::test::Session next{cell.timeline, cell.driver};
  next.begin();
  REQUIRE(cell.driver.trouble().empty());
  CHECK(cell.session.deliveries.empty());
  cell.driver.receive(request_wrench, {});
  cell.timeline.advance_to(cell.timeline.now() + 6ms);
  REQUIRE(next.deliveries.size() == 1);
  CHECK(next.deliveries[0].fields[0] == Approx(3.1));  // the zero is kept
  CHECK(next.faults.empty());
}

TEST_CASE("force-torque driver: what goes wrong on the line ends the skill, in words", "[force-torque]") {
  Cell cell;
  std::string expected;
  SECTION("unplugged") {
    cell.driver.receive(request_wrench, {});
    cell.wire.cut("unplugged");
    expected = "the link is broken: unplugged";
  }
  SECTION("dropout") {
    cell.wire.tamper([](Direction direction, std::vector<std::uint8_t>& bytes) {
      if (direction == Direction::to_a && bytes.size() > 4) bytes.resize(4);
    });
    cell.driver.receive(request_wrench, {});
    expected =
        "only 4 of the 13 bytes of a record came within 20 ms; is it switched on, and is its cable plugged "
        "in?";
  }
  SECTION("late") {
    cell.sensor.slow_down(30ms);
    cell.driver.receive(request_wrench, {});
    expected = "no record came within 20 ms; is it switched on, and is its cable plugged in?";
  }
  SECTION("garbled") {
    cell.wire.tamper([](Direction direction, std::vector<std::uint8_t>& bytes) {
      if (direction == Direction::to_a && bytes.size() > 4) bytes[0] ^= 0x55U;
    });
    cell.driver.receive(request_wrench, {});
    expected = "a record begins with the byte 55, which is no overload byte";
  }
  SECTION("bytes that were not asked for") {
    cell.wire.b().write(runtime::drivers::as_bytes("oops"));
    expected = "sends \"o\" without being asked";
  }
  cell.timeline.advance_to(cell.timeline.now() + 25ms);
  CHECK(cell.session.faults == std::vector<std::string>{expected});
  CHECK(cell.driver.trouble() == expected);
  CHECK(cell.session.deliveries.empty());

  // The next session starts the sensor again.
  cell.driver.close();
  cell.wire.mend();
  cell.wire.tamper(nullptr);
  cell.sensor.slow_down(0ms);
  cell.session.faults.clear();
  cell.timeline.advance_to(cell.timeline.now() + 100ms);
  cell.session.begin();
  CHECK(cell.driver.trouble().empty());
  cell.read();
}

TEST_CASE("force-torque driver: the text of an earlier start that waits in the line is no answer",
          "[force-torque]") {
  for (const Time waited : {0ms, 1ms, 5ms, 20ms}) {
    CAPTURE(waited.count());
    Bench bench(quiet);
    bench.timeline.advance_to(1s);  // nobody has read what the sensor sent
    ForceTorqueDriver driver{bench.timeline, bench.wire.a()};
    driver.prepare();
    bench.timeline.advance_to(bench.timeline.now() + waited);
    bench.wire.b().write(runtime::drivers::as_bytes("\r\nF/T sensor, 65 N, 5 N*m\r\n>"));
    bench.timeline.advance_to(bench.timeline.now() + 2s);
    CHECK(driver.trouble().empty());
    CHECK(driver.ready());
  }
}

TEST_CASE("force-torque driver: a sensor that does not start is trouble before the skill", "[force-torque]") {
  Timeline timeline;
  Wire wire{timeline, {38400, 10}};
  ForceTorqueDriver driver{timeline, wire.a()};
  runtime::drivers::test::Session session{timeline, driver};
  session.begin();
  CHECK(timeline.now() == 1s);
  CHECK(driver.trouble() ==
        "no prompt came after control W within 1000 ms; is it switched on, and is its cable plugged in?");
  CHECK(session.faults.empty());
}

}  // namespace
}  // namespace pal::sim
