// How truly the gripper holds: creep at rest, and drift of a part that is moved.
#include <fmt/format.h>

#include <stdexcept>

#include "sim/controller/motion_controller.hpp"
#include "sim/model/mujoco_physics.hpp"
#include "sim/workcell.hpp"
#include "tests/benchmark/workcell/row.hpp"

namespace pal::bench {
namespace {

using namespace std::chrono_literals;

constexpr double on_table = -181.8 + 25;  // mm, the middle of a block of 50 mm
constexpr double lifted = on_table + 60;

/// The part of scene `parts`, and the arm that handles it. Lengths in mm.
class Handling {
 public:
  Eigen::Vector3d part() {
    const mjData& data = workcell_.physics().data();
    return 1e3 * (workcell_.physics().base_pose().inverse() *
                  Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(data.xpos + 3 * part_)));
  }
  Eigen::Vector3d in_hand() { return 1e3 * (workcell_.tool().inverse() * Eigen::Vector3d(part() * 1e-3)); }

  void go(double x, double y, double z) {
    sim::Pose goal = workcell_.set_point();
    goal.translation() = 1e-3 * Eigen::Vector3d(x, y, z);
    if (workcell_.motion().move_straight(goal, {}, workcell_.now()))
      throw std::runtime_error("a motion is refused");
    while (!workcell_.idle()) wait(sim::alter_period);
    wait(200ms);
  }
  void wait(runtime::Time time) {
    workcell_.advance_to(workcell_.now() + time);
    if (workcell_.fault()) throw std::runtime_error(workcell_.fault()->text);
  }
  void close() {
    workcell_.gripper_close();
    wait(800ms);
    if (!workcell_.holds_part()) throw std::runtime_error("the gripper holds no part");
  }
  void open() {
    workcell_.gripper_open();
    wait(600ms);
  }

 private:
  sim::Workcell workcell_{sim::find_scene("parts", {PAL_SCENE_DIR}), {.keep_log = false}};
  int part_ = mj_name2id(&workcell_.physics().model(), mjOBJ_BODY, "part");
};

double creep() {
  Handling hand;
  hand.go(460, -200, on_table);
  hand.close();
  hand.go(460, -200, lifted);
  const Eigen::Vector3d before = hand.in_hand();
  hand.wait(30s);
  return (hand.in_hand() - before).norm();
}

/// Six moves to and fro; how far from where it began the part stands.
double drift() {
  Handling hand;
  double x = 460, y = -200;
  for (int i = 0; i < 6; ++i) {
    hand.go(x, y, on_table);
    hand.close();
    hand.go(x, y, lifted);
    x = i % 2 == 0 ? 540 : 460;
    y = i % 2 == 0 ? -120 : -200;
    hand.go(x, y, lifted);
    hand.go(x, y, on_table);
    hand.open();
    hand.go(x, y, lifted);
  }
  return (hand.part() - Eigen::Vector3d(460, -200, on_table)).norm();
}

}  // namespace

std::vector<Row> grasp_rows() {
  const double crept = creep(), drifted = drift();
  return {{"creep of a part in the gripper, 30 s", fmt::format("{:.4f} mm", crept), "below 0.01 mm",
           crept < 0.01},
          {"drift of a part moved six times", fmt::format("{:.3f} mm", drifted), "at most 0.5 mm",
           drifted <= 0.5}};
}

}  // namespace pal::bench
