// VAL and the physics: what a person at the terminal would see.
#include <catch2/catch.hpp>

#include "runtime/drivers/alter/driver.hpp"
#include "runtime/drivers/val/alter_opener.hpp"
#include "runtime/drivers/val/driver.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/cell/cell.hpp"
#include "sim/cell/corrected_arm.hpp"
#include "sim/controller/motion_controller.hpp"
#include "sim/devices/alter_emulator.hpp"
#include "sim/val/controller.hpp"
#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;
using namespace pal::sim::val;
using pal::runtime::Time;

namespace {

struct Bench final : pal::runtime::drivers::LinkUser {
  explicit Bench(const std::string& name) : workcell(scene(name)) { wire.a().connect(this); }
  void on_bytes(pal::runtime::drivers::Bytes bytes) override {
    seen += pal::runtime::drivers::as_text(bytes);
  }
  void on_break(std::string_view) override {}

  void pass(Time time) {
    for (const Time end = timeline.now() + time; timeline.now() < end;) {
      const Time next = std::min(end, timeline.next());
      workcell.advance_to(next);
      timeline.advance_to(next);
    }
  }
  // The answer to a line, as soon as its prompt is there.
  std::string ask(const std::string& line) {
    seen.clear();
    wire.a().write(pal::runtime::drivers::as_bytes(line + "\r"));
    for (int i = 0; i < 10000 && !seen.ends_with("\n."); ++i) pass(1ms);
    const std::string echo = line + "\r\n";
    return seen.starts_with(echo) && seen.ends_with(".")
               ? seen.substr(echo.size(), seen.size() - echo.size() - 1)
               : "no answer: " + seen;
  }
  double off(const Pose& wanted) const {
    return (workcell.tool().translation() - wanted.translation()).norm();
  }

  Workcell workcell;
  pal::runtime::drivers::Timeline timeline;
  pal::runtime::drivers::Wire alter_wire{timeline, pal::runtime::drivers::alter::line};
  pal::sim::CorrectedArm altered{workcell};
  AlterEmulator alter{timeline, alter_wire.b(), altered};
  pal::runtime::drivers::Wire wire{timeline, {.baud = 9600}};
  Controller controller{timeline, wire.b(), workcell, &alter};
  std::string seen;
};

}  // namespace

TEST_CASE("VAL in the workcell: a straight line and back") {
  Bench cell("nothing");
  const Pose start = cell.workcell.tool();
  CHECK(cell.ask("DO HERE a") == "");
  CHECK(cell.ask("SPEED 50") == "");  // 0.25 m/s
  CHECK(cell.ask("DO MOVES SHIFT(a BY 0,150,50)") == "");
  CHECK(cell.off(Eigen::Translation3d(0, 0.15, 0.05) * start) < 0.15e-3);
  cell.pass(150ms);
  // 0.05 mm, and the play and the counts of the machine's joints.
  CHECK(cell.off(Eigen::Translation3d(0, 0.15, 0.05) * start) < 0.15e-3);
  CHECK(cell.ask("DO MOVE a") == "");
  cell.pass(150ms);
  CHECK(cell.off(start) < 0.15e-3);
}

TEST_CASE("VAL in the workcell: a collision ends the motion, and CALIBRATE allows the next") {
  Bench cell("touch");
  CHECK(cell.ask("DO HERE a") == "");
  CHECK(cell.ask("DO MOVES SHIFT(a BY 0,0,-250)").starts_with("*Arm fault* "));
  REQUIRE(cell.workcell.fault());
  CHECK(cell.ask("DO MOVES a").starts_with("*Arm fault* "));
  CHECK(cell.ask("CALIBRATE") == "");
  CHECK_FALSE(cell.workcell.fault());
  CHECK(cell.ask("DO MOVES a") == "");
  cell.pass(150ms);
  CHECK(cell.off(cell.controller.store().locations["A"]) < 0.15e-3);
}

TEST_CASE("VAL in the workcell: OPENI and CLOSEI wait for the fingers") {
  Bench cell("empty-place");
  CHECK(cell.ask("DO OPENI") == "");
  CHECK(cell.workcell.gripper_width() == Approx(80).margin(1));
  const Time begin = cell.timeline.now();
  CHECK(cell.ask("DO CLOSEI") == "");
  CHECK(cell.timeline.now() - begin > 700ms);  // 80 mm at 100 mm/s
  CHECK(cell.workcell.gripper_width() == Approx(0).margin(1));
}

TEST_CASE("VAL in the workcell: VAL opens ALTER, and TOOL sets the point that turns") {
  Bench cell("nothing");
  pal::runtime::drivers::ValDriver val(cell.timeline, cell.wire.a());
  pal::runtime::drivers::val::AlterOpener opener(val);
  std::string problem = "no answer yet";
  const auto done = [&](const std::string& text) { problem = text; };
  opener.open({.world = false, .cumulative = true}, done);
  cell.pass(500ms);
  CHECK(problem.empty());
  CHECK(cell.alter.is_open() == false);  // it was not answered, so it has ended itself
  opener.close(done);
  cell.pass(500ms);
  CHECK(problem.find("ALTER") == 0);
  std::optional<pal::runtime::drivers::val::Answer> answer;
  val.submit({pal::runtime::drivers::val::Verb::set_figures, "SEAM", {}, {49, 0, 397, 90, -90, 0}}, nullptr);
  val.submit({pal::runtime::drivers::val::Verb::tool, "SEAM", {}, {}},
             [&](const auto& given) { answer = given; });
  cell.pass(500ms);
  REQUIRE(answer);
  CHECK(answer->ok);
  CHECK((cell.altered.tool().translation() -
         tool_pose(cell.workcell.encoder_joints(), Pose(Eigen::Translation3d(0.049, 0, 0.397))).translation())
            .norm() < 1e-9);
}

TEST_CASE("VAL in the station: the driver is ready for a skill, and commands the arm") {
  pal::sim::Cell cell(scene("nothing"));
  cell.val_store().locations["UP"] = Eigen::Translation3d(0, 0, 0.05) * cell.workcell().set_point();
  cell.val_driver().prepare();
  for (int i = 0; i < 1000 && !cell.val_driver().ready(); ++i) cell.station().idle(1ms);
  CHECK(cell.val_driver().trouble().empty());
  std::optional<pal::runtime::drivers::val::Answer> answer;
  cell.val_driver().submit({pal::runtime::drivers::val::Verb::move_straight, "UP", {}, {}},
                           [&](const auto& given) { answer = given; });
  for (int i = 0; i < 2000 && !answer; ++i) cell.station().idle(1ms);
  REQUIRE(answer);
  CHECK(answer->ok);
  CHECK((cell.workcell().tool().translation() - cell.val_store().locations["UP"].translation()).norm() <
        0.15e-3);
}
