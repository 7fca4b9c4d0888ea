#include "sim/controller/trail.hpp"

#include <algorithm>

namespace pal::sim {
namespace {

constexpr double between_marks = 0.25e-3;  // m
// So far from its set-point an arm that moves freely never is (tests/unit/sim/servo_test.cpp), nor one that
// presses on purpose.
constexpr double follows = 1e-3;  // m
// An arm that stops at 5 mm from its set-point is not farther than this from where it began to fall behind.
constexpr double near = 15e-3;  // m
// A tool that turns about its tip moves other parts of the arm: a turn of a joint counts at this distance.
constexpr double lever = 0.2;  // m

}  // namespace

double Trail::distance(const Joints& a, const Joints& b) const {
  return std::max(lever * (a - b).cwiseAbs().maxCoeff(),
                  (tool_pose(a, tool_).translation() - tool_pose(b, tool_).translation()).norm());
}

void Trail::note(const Joints& q, const Joints& wanted) {
  if (count_ > 0 && distance(q, marks_[last_]) < between_marks) return;
  if (distance(q, wanted) > follows) return;
  if (count_ > 0) last_ = (last_ + 1) % capacity;
  marks_[last_] = q;
  count_ = std::min(count_ + 1, capacity);
}

bool Trail::leads_back(const Joints& from) const {
  return count_ > 0 && distance(from, mark(0)) < near;
}

Joints Trail::back(const Joints& from, double part) const {
  constexpr double to_the_last = 1.0 / 3;
  if (part < to_the_last) return from + part / to_the_last * (mark(0) - from);
  const double place = (part - to_the_last) / (1 - to_the_last) * static_cast<double>(count_ - 1);
  const auto whole = static_cast<std::size_t>(place);
  if (whole + 1 >= count_) return mark(count_ - 1);
  const double rest = place - static_cast<double>(whole);
  return (1 - rest) * mark(whole) + rest * mark(whole + 1);
}

}  // namespace pal::sim
