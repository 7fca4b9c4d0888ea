// Turns as VAL names them, against the emulated controller's own arithmetic.
#include <catch2/catch.hpp>
#include <numbers>

#include "sim/val/transformation.hpp"
#include "skills_pal/modules/val_turn.hpp"

using namespace pal;

TEST_CASE("val_turn: VAL reads the turn that was meant, upright ones too") {
  const double rx = GENERATE(-90, -37, 0, 12, 90), ry = GENERATE(-90, -45, 0, 60, 90),
               rz = GENERATE(-90, 0, 5, 90);
  const skills::ValTurn turn = skills::val_turn(rx, ry, rz);
  constexpr double degree = std::numbers::pi / 180;
  const Eigen::Matrix3d meant = (Eigen::AngleAxisd(rz * degree, Eigen::Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(ry * degree, Eigen::Vector3d::UnitY()) *
                                 Eigen::AngleAxisd(rx * degree, Eigen::Vector3d::UnitX()))
                                    .toRotationMatrix();
  const Eigen::Matrix3d read = sim::val::pose_of({0, 0, 0, turn.o, turn.a, turn.t}).rotation();
  CHECK((meant - read).cwiseAbs().maxCoeff() < 1e-7);
}

TEST_CASE("val_turn: no turn is 90, -90, 0") {
  const skills::ValTurn turn = skills::val_turn(0, 0, 0);
  CHECK(turn.o == Approx(90));
  CHECK(turn.a == Approx(-90));
  CHECK(turn.t == Approx(0).margin(1e-9));
}
