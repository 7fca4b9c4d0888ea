// The ALTER driver and the emulated port at the two ends of their line, with the arm in physics.
#include <catch2/catch.hpp>
#include <fstream>

#include "runtime/drivers/alter/driver.hpp"
#include "sim/cell/corrected_arm.hpp"
#include "tests/unit/sim/support.hpp"

using namespace pal;
using namespace pal::sim;
using namespace pal::sim::test;
namespace alter = pal::runtime::drivers::alter;

namespace {

constexpr std::size_t tick_port = 0;
constexpr std::size_t correction_port = 1;
constexpr auto request_time = 2170139ns;  // until a request has passed the line

struct Opener final : alter::Opener {
  explicit Opener(AlterControl& control) : port(control) {}
  void open(const AlterMode& mode, Done done) override { done(port.open(mode)); }
  void close(Done done) override { done(port.close()); }
  AlterControl& port;
};

struct AlterCell {
  // Answers each tick after `delay` with `dz` mm.
  void answer(runtime::Time delay, double dz) {
    host.on_delivery = [this, delay, dz](const Host::Delivery& delivery) {
      if (delivery.port != tick_port) return;
      timeline.after(delay, [this, dz] { correct(dz); });
    };
  }
  void correct(double dz) { driver.receive(correction_port, std::array<double, 6>{0, 0, dz, 0, 0, 0}); }
  void begin() {
    driver.prepare();
    driver.attach(host);
    driver.open();
  }
  void run_until(runtime::Time end) {
    while (timeline.next() <= end) {
      const runtime::Time next = timeline.next();
      workcell.advance_to(next);
      host.run_until(next);
      timeline.advance_to(next);
    }
    workcell.advance_to(end);
    timeline.advance_to(end);
  }
  double height() const { return workcell.tool().translation().z() * 1e3; }

  Workcell workcell{scene("touch")};
  Host host{workcell};
  runtime::drivers::Timeline timeline;
  CorrectedArm arm{workcell};
  runtime::drivers::Wire wire{timeline, alter::line};
  AlterEmulator port{timeline, wire.b(), arm};
  Opener opener{port};
  runtime::drivers::AlterDriver driver{timeline, wire.a(), opener};
};

}  // namespace

TEST_CASE("alter: the dialogue in the documentation is what passes the line") {
  AlterCell cell;
  std::vector<std::string> frames;  // as the page writes them, without blanks
  cell.wire.tamper([&](runtime::drivers::Carrier::Direction direction, std::vector<std::uint8_t>& bytes) {
    std::string text = direction == runtime::drivers::Carrier::Direction::to_a ? "controller" : "driver";
    for (const std::uint8_t byte : bytes) {
      constexpr const char* digits = "0123456789abcdef";
      text += {digits[byte >> 4U], digits[byte & 15U]};
    }
    frames.push_back(text);
  });
  // Each tick is answered 3.5 ms after its cycle began: the fifth with a motion.
  int ticks = 0;
  cell.host.on_delivery = [&](const Host::Delivery& delivery) {
    if (delivery.port != tick_port) return;
    cell.timeline.after(3500us - request_time, [&cell, now = ++ticks] { cell.correct(now == 5 ? 0.56 : 0); });
  };
  cell.begin();
  cell.run_until(6 * alter_period + 4ms);
  REQUIRE(frames.size() >= 11);

  std::ifstream page(PAL_SCENE_DIR "/../../docs/workcell/alter.md");
  std::vector<std::string> written;
  bool fenced = false, dialogue = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) dialogue = line == "## A dialogue";
    if (line.starts_with("```")) fenced = !fenced;
    const std::size_t bytes = line.find(" 7e ");
    if (!dialogue || !fenced || bytes == std::string::npos) continue;
    std::string text = line.find("controller") != std::string::npos ? "controller" : "driver";
    for (std::size_t i = bytes; i < line.size(); ++i)
      if (line[i] != ' ') text += line[i];
    written.push_back(text);
  }
  REQUIRE(written.size() == 3);  // a request, its answer, the next request
  CHECK(std::vector<std::string>(frames.begin() + 8, frames.begin() + 11) == written);
}

TEST_CASE("alter: ports as the skills declare them") {
  const AlterCell cell;
  const auto& ports = cell.driver.ports();
  REQUIRE(ports.size() == 4);
  CHECK(ports[0] == runtime::PortSpec{"tick", false, {}});
  CHECK(ports[1] ==
        runtime::PortSpec{
            "correction",
            true,
            {{"dx", "mm"}, {"dy", "mm"}, {"dz", "mm"}, {"rx", "deg"}, {"ry", "deg"}, {"rz", "deg"}}});
  CHECK(ports[3].message == "position");
}

TEST_CASE("alter: a tick comes every 28 ms, and the next one is known") {
  AlterCell cell;
  cell.answer(1ms, 0);
  CHECK_FALSE(cell.driver.ready());
  cell.begin();
  cell.run_until(150ms);
  CHECK(cell.driver.ready());
  REQUIRE(cell.host.deliveries.size() == 5);
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(cell.host.deliveries[i].time == (i + 1) * alter_period + request_time);
  CHECK(cell.driver.next_tick(150ms) == 6 * alter_period + request_time);
  CHECK(cell.driver.next_tick(6 * alter_period + request_time) == 6 * alter_period + request_time);
  CHECK(cell.host.faults.empty());
}

TEST_CASE("alter: between sessions the controller is answered with no motion, for 10,000 cycles") {
  AlterCell cell;
  cell.driver.prepare();
  // The line alone: physics has nothing to do.
  cell.timeline.advance_to(10'000 * alter_period);
  CHECK(cell.driver.trouble().empty());
  CHECK(cell.driver.ready());
  CHECK(cell.port.is_open());
  CHECK(cell.workcell.idle());
}

TEST_CASE("alter: a correction is moved in the cycle after the one that it answers") {
  AlterCell cell;
  cell.answer(20ms, 1.0);  // as late as the environment allows
  const double start = cell.height();
  cell.begin();
  cell.run_until(56ms);  // cycles begin at 28 and 56 ms
  CHECK(cell.height() == Approx(start).margin(0.005));
  cell.run_until(84ms);
  CHECK(start - cell.height() == Approx(1.0).margin(0.05));  // servos follow within 50 micrometres
  cell.run_until(56ms + 10 * 28ms);
  CHECK(start - cell.height() == Approx(10.0).margin(0.05));
  CHECK(cell.host.faults.empty());
}

TEST_CASE("alter: small corrections do not drift by rounding") {
  AlterCell cell;
  cell.answer(1ms, 0.0104);
  const double start = cell.workcell.set_point().translation().z() * 1e3;
  cell.begin();
  cell.run_until(56ms + 250 * 28ms);
  CHECK(start - cell.workcell.set_point().translation().z() * 1e3 == Approx(250 * 0.0104).margin(0.002));
}

TEST_CASE("alter: no answer in time stops the arm with a fault") {
  AlterCell cell;
  cell.answer(1ms, 1.0);
  cell.begin();
  cell.run_until(100ms);  // the arm is moving
  cell.host.on_delivery = nullptr;
  cell.run_until(4 * alter_period + 24ms);
  CHECK(cell.host.faults.empty());
  CHECK(cell.workcell.idle());
  cell.run_until(4 * alter_period + 40ms);  // the controller's message has passed
  REQUIRE(cell.host.faults.size() == 1);
  CHECK(cell.host.faults[0] == "got no correction within 24 ms of the beginning of its cycle");
  CHECK(cell.driver.trouble() == cell.host.faults[0]);
  const double there = cell.height();
  cell.run_until(600ms);
  CHECK(cell.height() == Approx(there).margin(0.1));  // the play of the gears
  CHECK(cell.host.faults.size() == 1);
  // The next session opens it again.
  cell.driver.close();
  cell.driver.prepare();
  cell.run_until(700ms);
  CHECK(cell.driver.trouble().empty());
  CHECK(cell.driver.ready());
}

TEST_CASE("alter: an unasked answer and an impossible motion are faults") {
  AlterCell cell;
  cell.begin();
  cell.run_until(31ms);
  SECTION("twice answered") {
    cell.correct(0);
    cell.correct(0);
    REQUIRE(cell.host.faults.size() == 1);
    CHECK(cell.host.faults[0] == "got a correction that it had not asked for");
  }
  SECTION("too fast") {
    cell.correct(20);
    cell.run_until(60ms);
    REQUIRE(cell.host.faults.size() == 1);
    CHECK(cell.host.faults[0].find("cannot make the motion: the tool would move at 0.714 m/s") == 0);
    CHECK(cell.workcell.idle());
  }
  SECTION("further than a correction can say") {
    cell.correct(40);
    REQUIRE(cell.host.faults.size() == 1);
    CHECK(cell.host.faults[0] ==
          "cannot make the motion: dz is 40.000000 mm, a correction has at most 32.767");
  }
}

TEST_CASE("alter: garbled, unplugged and silent lines are told apart") {
  AlterCell cell;
  cell.answer(1ms, 0.5);
  cell.begin();
  cell.run_until(100ms);
  SECTION("requests are garbled") {
    cell.wire.tamper([](auto direction, auto& bytes) {
      if (direction == runtime::drivers::Carrier::Direction::to_a) bytes[4] ^= 0x10U;
    });
    cell.run_until(300ms);
    REQUIRE(cell.host.faults.size() == 1);
    CHECK(cell.host.faults[0] == "the line is disturbed: a frame's checksum is wrong");
  }
  SECTION("answers are garbled") {
    cell.wire.tamper([](auto direction, auto& bytes) {
      if (direction == runtime::drivers::Carrier::Direction::to_b) bytes[4] ^= 0x10U;
    });
    cell.run_until(300ms);
    REQUIRE(cell.host.faults.size() == 1);
    CHECK(cell.host.faults[0] ==
          "got no correction within 24 ms of the beginning of its cycle; what came was garbled");
  }
  SECTION("unplugged") {
    cell.wire.cut("unplugged");
    REQUIRE(cell.host.faults.size() == 1);
    CHECK(cell.host.faults[0] == "the link is broken: unplugged");
  }
  SECTION("switched off") {
    cell.wire.tamper([](auto, auto& bytes) { bytes.clear(); });
    cell.run_until(300ms);
    REQUIRE(cell.host.faults.size() == 1);
    CHECK(cell.host.faults[0] ==
          "has asked for nothing for 60 ms; is the controller switched on, and is its cable plugged in?");
  }
  cell.run_until(600ms);
  CHECK(cell.workcell.idle());
  CHECK_FALSE(cell.port.is_open());
}

TEST_CASE("alter: after its session the arm ends the accepted motions and stands still") {
  AlterCell cell;
  cell.answer(1ms, 1.0);
  const double start = cell.height();
  cell.begin();
  cell.run_until(62ms);  // cycles at 28 and 56 ms, both answered
  cell.driver.close();
  cell.run_until(56ms + 2 * 28ms);
  CHECK(cell.workcell.idle());
  cell.run_until(300ms);
  CHECK(start - cell.height() == Approx(2.0).margin(0.1));  // the play of the gears
  CHECK(cell.port.is_open());
  cell.driver.release();
  CHECK(cell.driver.released());
  CHECK_FALSE(cell.port.is_open());
}

TEST_CASE("alter: the position is the tool's, of the last request") {
  AlterCell cell;
  cell.answer(1ms, 0);
  cell.begin();
  cell.run_until(40ms);
  cell.driver.receive(2, {});
  const auto& got = cell.host.deliveries.back();
  CHECK(got.port == 3);
  // As the encoders show it: counts and play are the machine's.
  const Eigen::Vector3d shown =
      tool_pose(cell.workcell.encoder_joints(), cell.workcell.flange_to_tip()).translation() * 1e3;
  const Eigen::Vector3d tool = cell.workcell.tool().translation() * 1e3;
  for (Eigen::Index i = 0; i < 3; ++i) {
    CHECK(got.fields[static_cast<std::size_t>(i)] == Approx(shown[i]).margin(0.005));
    CHECK(got.fields[static_cast<std::size_t>(i)] == Approx(tool[i]).margin(0.1));
  }
  CHECK(std::abs(got.fields[3]) == Approx(180).margin(0.05));  // the tool points straight down
}
