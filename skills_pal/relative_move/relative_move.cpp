#include "skills_pal/relative_move/relative_move.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "relative_move_skill.hpp"
#include "skills_pal/modules/commands.hpp"

namespace pal::skills {

namespace {

using namespace relative_move;

/// As VAL names a turn, deg: R = Rz(O) M Ry(A) Rz(T), where M has the rows (0 1 0), (0 0 -1), (-1 0 0).
struct Turn {
  double o = 0, a = 0, t = 0;
};

/// Turns about x, then y, then z of the frame as it was; deg.
Turn turn_of(double rx, double ry, double rz) {
  constexpr double degree = std::numbers::pi / 180;
  const double cx = std::cos(rx * degree), sx = std::sin(rx * degree), cy = std::cos(ry * degree),
               sy = std::sin(ry * degree), cz = std::cos(rz * degree), sz = std::sin(rz * degree);
  // The elements of Rz Ry Rx that are needed.
  const double r00 = cz * cy, r01 = cz * sy * sx - sz * cx, r02 = cz * sy * cx + sz * sx;
  const double r12 = sz * sy * cx - cz * sx;
  const double r20 = -sy, r21 = cy * sx, r22 = cy * cx;
  Turn turn;
  turn.a = -std::asin(std::clamp(r22, -1.0, 1.0)) / degree;
  if (std::abs(r22) > 1 - 1e-9) {  // O and T turn about one line: T is 0
    turn.o = std::atan2(r00 * r22, r01) / degree;
    return turn;
  }
  turn.o = std::atan2(r02, -r12) / degree;
  turn.t = std::atan2(r21, -r20) / degree;
  return turn;
}

class Method final : public SM1Activities {
 public:
  explicit Method(std::shared_ptr<CommandList<Command>> list) : list_(std::move(list)) {}

  void start(const Parameters& parameters) override { parameters_ = parameters; }

  void list_motion() override {
    list_->begin();
    const runtime::Text name("PALRELATIVE");
    const Turn turn = turn_of(parameters_.rx, parameters_.ry, parameters_.rz);
    list_->add(Verb::speed, 100).add(Verb::straight_speed, parameters_.speed);
    Command& way = list_->add(Verb::set_figures, name, parameters_.dx, parameters_.dy, parameters_.dz).last();
    way.d = turn.o;
    way.e = turn.a;
    way.f = turn.t;
    list_->add(Verb::straight_relative, name);
  }

 private:
  std::shared_ptr<CommandList<Command>> list_;
  Parameters parameters_;
};

}  // namespace

std::unique_ptr<runtime::Skill> relative_move_skill() {
  auto list = std::make_shared<CommandList<Command>>();
  return make_relative_move(std::make_unique<Method>(list), std::make_unique<Commands<SM2Activities>>(list));
}

}  // namespace pal::skills
