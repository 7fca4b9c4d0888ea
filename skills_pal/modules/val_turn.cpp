#include "skills_pal/modules/val_turn.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pal::skills {

ValTurn val_turn(double rx, double ry, double rz) {
  constexpr double degree = std::numbers::pi / 180;
  constexpr double upright = 1e-9;
  const double cx = std::cos(rx * degree), sx = std::sin(rx * degree);
  const double cy = std::cos(ry * degree), sy = std::sin(ry * degree);
  const double cz = std::cos(rz * degree), sz = std::sin(rz * degree);
  // The elements of Rz Ry Rx that are needed.
  const double r00 = cz * cy, r01 = cz * sy * sx - sz * cx, r02 = cz * sy * cx + sz * sx;
  const double r12 = sz * sy * cx - cz * sx;
  const double r20 = -sy, r21 = cy * sx, r22 = cy * cx;
  ValTurn turn;
  turn.a = -std::asin(std::clamp(r22, -1.0, 1.0)) / degree;
  if (std::hypot(r20, r21) < upright) {
    turn.o = std::atan2(r00 * r22, r01) / degree;
    return turn;
  }
  turn.o = std::atan2(r02, -r12) / degree;
  turn.t = std::atan2(r21, -r20) / degree;
  return turn;
}

}  // namespace pal::skills
