// Approach to touch, both orders, generated and run against a wall like a spring.
#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "pal/runtime/dispatcher.hpp"
#include "tests/run/support/allocation_count.hpp"
#include "tests/run/support/bench.hpp"
#include "tests/run/support/touch_cell.hpp"
#include "tests/support/built_skills.hpp"

using namespace pal;
using namespace pal::test;

namespace {

struct Cell {
  explicit Cell(runtime::Time phase = 5ms, runtime::Time answer = 6ms)
      : sensor(tool, answer), alter(tool, phase) {}

  runtime::Outcome run(const std::string& name, std::vector<runtime::ParameterValue> parameters = {},
                       const runtime::RunOptions& options = {}) {
    const auto skill = test::make_skill(name);
    REQUIRE(skill != nullptr);
    runtime::Device* devices[] = {&sensor, &alter};
    NoWorld world;
    return runtime::Dispatcher(devices, world).run(*skill, parameters, options);
  }

  Tool tool;
  ForceSensor sensor;
  AlterPort alter;
};

std::string json(const runtime::Outcome& outcome) {
  std::ostringstream out;
  trace::write_json(outcome.trace, out);
  return out.str();
}

}  // namespace

TEST_CASE("meets a wall and stands still") {
  const std::string skill = GENERATE("touch", "touch-read-first");
  Cell cell;
  cell.tool.wall = 20;
  const auto outcome = cell.run(skill);
  CHECK(outcome.code == 0);
  CHECK_FALSE(outcome.fault);
  CHECK(outcome.reason == "The tool touches the surface.");
  CHECK(outcome.overruns == 0);
  // 20 mm at 20 mm/s, and a little more.
  CHECK(outcome.duration > 1s);
  CHECK(outcome.duration < 1200ms);
  // It presses harder than 5 N, and by no more than 62 ms of the way at 20 mm/s and 10 N/mm beyond that.
  const double force = -cell.tool.fz(outcome.duration + 28ms);
  CHECK(force >= 5);
  CHECK(force <= 5 + 0.062 * 20 * 10);
  CHECK(cell.sensor.closed);
  CHECK(cell.alter.closed);
}

TEST_CASE("meets nothing and goes back to where it began") {
  const std::string skill = GENERATE("touch", "touch-read-first");
  const double speed = GENERATE(20.0, 7.3, 60.0);
  Cell cell;
  const auto outcome = cell.run(skill, {{"reach", 10}, {"approach-speed", speed}});
  CHECK(outcome.code == 1);
  CHECK(outcome.reason == "No force as great as the threshold was met; the tool is back where it began.");
  CHECK(cell.tool.target() == Approx(0).margin(1e-9));
  CHECK(cell.tool.furthest == Approx(10));
  CHECK(outcome.duration >
        std::chrono::duration_cast<runtime::Time>(std::chrono::duration<double>(20 / speed)));
}

TEST_CASE("ALTER is always answered in time") {
  const std::string skill = GENERATE("touch", "touch-read-first");
  const auto phase_ms = GENERATE(range(0, 28, 3));
  Cell cell{std::chrono::milliseconds(phase_ms)};
  cell.tool.wall = 5;
  const auto outcome = cell.run(skill, {}, {.costs = runtime::CostPolicy::random, .seed = 7});
  CHECK(outcome.code == 0);
  CHECK(cell.alter.opened == 0ns);
  CHECK(cell.alter.asked - cell.alter.answered <= 1);  // the last may come with the end of the skill
  CHECK(cell.alter.slowest <= 6ms);
}

TEST_CASE("with the condition read first the tool presses further") {
  // The same phases, the same answers of the sensor: only the order differs.
  double greatest[2] = {0, 0};
  double sum[2] = {0, 0};
  int runs = 0;
  for (auto phase = 0us; phase < 28ms; phase += 437us) {
    ++runs;
    for (int order = 0; order < 2; ++order) {
      Cell cell{phase, 5800us};
      cell.tool.wall = 10.2;
      const auto outcome = cell.run(order == 0 ? "touch" : "touch-read-first");
      REQUIRE(outcome.code == 0);
      const double pressed = -cell.tool.fz(outcome.duration + 28ms);
      sum[order] += pressed;
      greatest[order] = std::max(greatest[order], pressed);
    }
  }
  CAPTURE(runs, sum[0] / runs, sum[1] / runs, greatest[0], greatest[1]);
  CHECK(sum[0] < sum[1]);
  CHECK(greatest[0] < greatest[1]);
}

TEST_CASE("the same run gives the same trace, byte for byte") {
  const std::string skill = GENERATE("touch", "touch-read-first");
  const runtime::RunOptions options{.costs = runtime::CostPolicy::random, .seed = 42};
  std::string traces[2];
  for (std::string& text : traces) {
    Cell cell;
    cell.tool.wall = 3;
    text = json(cell.run(skill, {}, options));
  }
  CHECK(traces[0] == traces[1]);
  Cell other;
  other.tool.wall = 3;
  CHECK(json(other.run(skill, {}, {.costs = runtime::CostPolicy::random, .seed = 43})) != traces[0]);
}

TEST_CASE("a skill can be run again") {
  const auto skill = test::make_skill("touch");
  std::string traces[2];
  for (std::string& text : traces) {
    Cell cell;
    runtime::Device* devices[] = {&cell.sensor, &cell.alter};
    NoWorld world;
    const runtime::ParameterValue reach[] = {{"reach", 5}};
    text = json(runtime::Dispatcher(devices, world).run(*skill, reach));
  }
  CHECK(traces[0] == traces[1]);
}

namespace {

/// Switches the counting on with the first event of the run and off when the devices are closed.
class Meter final : public runtime::World {
 public:
  void advance_to(runtime::Time) override { count_allocations(true); }
};

}  // namespace

TEST_CASE("nothing is allocated while the skill runs") {
  const double wall = GENERATE(20.0, 1e9);  // touching, and going back by CM1
  const auto skill = test::make_skill("touch");
  Cell cell;
  cell.tool.wall = wall;
  class Alarm final : public runtime::Device {
   public:
    explicit Alarm(runtime::Device& device) : device_(device) {}
    const std::string& name() const override { return device_.name(); }
    const std::vector<runtime::PortSpec>& ports() const override { return device_.ports(); }
    void attach(runtime::DeviceHost& host) override { device_.attach(host); }
    void open() override { device_.open(); }
    void receive(std::size_t port, std::span<const double> fields) override { device_.receive(port, fields); }
    void close() override {
      count_allocations(false);
      device_.close();
    }

   private:
    runtime::Device& device_;
  } sensor{cell.sensor};
  runtime::Device* devices[] = {&sensor, &cell.alter};
  Meter meter;
  reset_allocations();
  const auto outcome = runtime::Dispatcher(devices, meter).run(*skill);
  count_allocations(false);
  CHECK(outcome.code == (wall < 1000 ? 0 : 1));
  CHECK(outcome.trace.events.size() > 1000);
  CHECK(counted_allocations() == 0);
}

TEST_CASE("forbidden parameters are refused before anything moves") {
  Cell cell;
  const auto outcome = cell.run("touch", {{"approach-speed", 61}});
  CHECK(outcome.fault);
  CHECK(outcome.code == 2);
  CHECK(outcome.reason == "parameter approach-speed is 61 mm/s; it may be from 1 to 60 mm/s");
  CHECK(cell.alter.opened < 0ns);
  CHECK(cell.run("touch", {{"aproach", 1}}).reason ==
        "skill touch has no parameter aproach; it has approach-speed, reach, threshold, stiffness");
}

TEST_CASE("a device that stops answering ends the skill with its error completion") {
  Cell cell;
  ScriptedDevice mute("force-torque", cell.sensor.ports());
  const auto skill = test::make_skill("touch");
  runtime::Device* devices[] = {&mute, &cell.alter};
  NoWorld world;
  const auto outcome = runtime::Dispatcher(devices, world).run(*skill, {}, {.horizon = 2s});
  CHECK(outcome.fault);
  CHECK(outcome.code == 2);
  CHECK(cell.alter.closed);
  CHECK(cell.alter.asked - cell.alter.answered <= 1);  // the robot was answered all the while
  CHECK(cell.tool.target() == 0);
}

TEST_CASE("a sensor that gives no number ends the skill where it is taken, and the robot stands") {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    Cell cell;
    ScriptedDevice broken("force-torque", cell.sensor.ports());
    broken.on_receive = [bad](runtime::DeviceHost& host, std::size_t, std::span<const double>) {
      host.at(host.now() + 6ms, [&host, bad] {
        const double fields[] = {0, 0, bad, 0, 0, 0};
        host.deliver(1, fields);
      });
    };
    const auto skill = test::make_skill("touch");
    runtime::Device* devices[] = {&broken, &cell.alter};
    NoWorld world;
    const auto outcome = runtime::Dispatcher(devices, world).run(*skill, {}, {.horizon = 2s});
    CHECK(outcome.fault);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.reason, Catch::Contains("a message's REAL field is not a finite number"));
    CHECK_THAT(outcome.reason, Catch::Contains("WTM( wrench from SD1 )") || Catch::Contains("force-torque"));
    CHECK(cell.alter.closed);
    CHECK(cell.tool.target() == 0);
  }
}
