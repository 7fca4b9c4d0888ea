#include "skills_pal/modules/looking.hpp"

#include <algorithm>

namespace pal::skills {

namespace {

double cut(double& left, double most) {
  const double part = std::clamp(left, -most, most);
  left -= part;
  return part;
}

}  // namespace

void Looking::start(double most_length, double most_turn) {
  *this = {};
  most_length_ = most_length;
  most_turn_ = most_turn;
}

void Looking::go(const Way& way) {
  left_ = way;
  stood_ = 0;
}

Way Looking::step() {
  Way part;
  part.dx = cut(left_.dx, most_length_);
  part.dy = cut(left_.dy, most_length_);
  part.dz = cut(left_.dz, most_length_);
  part.rx = cut(left_.rx, most_turn_);
  part.ry = cut(left_.ry, most_turn_);
  const bool stands = part.dx == 0 && part.dy == 0 && part.dz == 0 && part.rx == 0 && part.ry == 0;
  stood_ = stands ? stood_ + 1 : 0;
  return part;
}

bool Looking::fresh_look(double taken) {
  if (stood_ < cycles_at_rest || taken <= last_taken_) return false;
  last_taken_ = taken;
  return true;
}

}  // namespace pal::skills
