// Turns as VAL names them.
#pragma once

namespace pal::skills {

/// The angles O, A and T of a location, deg: R = Rz(O) M Ry(A) Rz(T), where M has the rows (0 1 0), (0 0 -1),
/// (-1 0 0). (90, -90, 0) turns nothing.
struct ValTurn {
  double o = 0, a = 0, t = 0;
};

/// Turns about x, then y, then z of a frame that stands still; deg. Where O and T turn about one line, T is
/// 0.
ValTurn val_turn(double rx, double ry, double rz);

}  // namespace pal::skills
