// VAL and the physics: what a person at the terminal would see.
#include <catch2/catch.hpp>

#include "runtime/drivers/wire.hpp"
#include "sim/val/terminal.hpp"
#include "sim/val/workcell_arm.hpp"
#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;
using namespace pal::sim::val;
using pal::runtime::Time;

namespace {

struct Cell final : pal::runtime::LinkUser {
  explicit Cell(const std::string& name) : workcell(scene(name)) { wire.a().connect(this); }
  void on_bytes(pal::runtime::Bytes bytes) override { seen += pal::runtime::as_text(bytes); }
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
    wire.a().write(pal::runtime::as_bytes(line + "\r"));
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
  pal::runtime::Timeline timeline;
  WorkcellArm arm{workcell, timeline};
  WorkcellHand hand{workcell, timeline};
  Machine machine{.timeline = timeline, .arm = arm, .hand = &hand};
  pal::runtime::Wire wire{timeline, {.baud = 9600}};
  Terminal terminal{wire.b(), machine};
  std::string seen;
};

}  // namespace

TEST_CASE("VAL in the workcell: a straight line and back, and where the tip is then") {
  Cell cell("nothing");
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

TEST_CASE("VAL in the workcell: what the arm hits ends the motion, and CALIBRATE lets it move again") {
  Cell cell("touch");
  CHECK(cell.ask("DO HERE a") == "");
  CHECK(cell.ask("DO MOVES SHIFT(a BY 0,0,-250)").starts_with("*Arm fault* "));
  REQUIRE(cell.workcell.fault());
  CHECK(cell.ask("DO MOVES a").starts_with("*Arm fault* "));
  CHECK(cell.ask("CALIBRATE") == "");
  CHECK_FALSE(cell.workcell.fault());
  CHECK(cell.ask("DO MOVES a") == "");
  cell.pass(150ms);
  CHECK(cell.off(cell.machine.base * cell.machine.store.locations["A"]) < 0.15e-3);
}

TEST_CASE("VAL in the workcell: OPENI and CLOSEI wait for the fingers") {
  Cell cell("empty-place");
  CHECK(cell.ask("DO OPENI") == "");
  CHECK(cell.workcell.gripper_width() == Approx(80).margin(1));
  const Time begin = cell.timeline.now();
  CHECK(cell.ask("DO CLOSEI") == "");
  CHECK(cell.timeline.now() - begin > 700ms);  // 80 mm at 100 mm/s
  CHECK(cell.workcell.gripper_width() == Approx(0).margin(1));
}
