#include "runtime/drivers/force_torque/zero.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pal::runtime::drivers::force_torque {
namespace {

struct Bounds {
  double force;   // N
  double torque;  // N*m
  double of(std::size_t axis) const { return axis < 3 ? force : torque; }
};

constexpr Bounds at_most{3, 0.2};     // of a sensor that is in order, from the day on which it was made
constexpr Bounds standing{1.5, 0.1};  // between two records of a tool that stands still
constexpr Bounds next_to_nothing{0.3, 0.02};  // less than any skill's contact
constexpr Bounds drift{1.5, 0.1};             // of a sensor that is in order, since its zero was taken
constexpr double following = 0.5;             // part of what is seen by which the zero follows

constexpr std::array<const char*, axes> words{"along x", "along y", "along z",
                                              "about x", "about y", "about z"};

/// The axis that is farthest beyond its bound, or nothing.
std::optional<std::size_t> beyond(const Load& load, const Bounds& bounds) {
  std::optional<std::size_t> worst;
  double most = 1;
  for (std::size_t i = 0; i < axes; ++i) {
    const double part = std::abs(load[i]) / bounds.of(i);
    if (part > most) most = part, worst = i;
  }
  return worst;
}

std::string amount(const Load& load, std::size_t axis) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), axis < 3 ? "%.1f N %s" : "%.2f N*m %s", load[axis], words[axis]);
  return text.data();
}

Load difference(const Load& a, const Load& b) {
  Load result{};
  for (std::size_t i = 0; i < axes; ++i) result[i] = a[i] - b[i];
  return result;
}

}  // namespace

void ZeroPoint::begin_look() {
  sum_ = {};
  count_ = 0;
}

void ZeroPoint::look(const Load& load) {
  if (count_++ == 0) least_ = greatest_ = load;
  for (std::size_t i = 0; i < axes; ++i) {
    sum_[i] += load[i];
    least_[i] = std::min(least_[i], load[i]);
    greatest_[i] = std::max(greatest_[i], load[i]);
  }
}

std::string ZeroPoint::end_look() {
  const Load changed = difference(greatest_, least_);
  const auto moving = beyond(changed, standing);
  if (known()) return moving ? std::string() : follow(mean());
  if (moving)
    return "the load changes by " + amount(changed, *moving) +
           " while its zero is taken; let the tool stand still in free air";
  return take(mean());
}

std::string ZeroPoint::take(const Load& mean) {
  if (const auto axis = beyond(mean, at_most))
    return "it has no zero yet, and shows " + amount(mean, *axis) +
           " beyond the tool's weight; move the tool into free air, with nothing in its fingers";
  known_ = first_ = mean;
  return {};
}

std::string ZeroPoint::follow(const Load& mean) {
  if (beyond(difference(mean, *known_), next_to_nothing)) return {};  // it touches, or holds something
  Load next = *known_;
  for (std::size_t i = 0; i < axes; ++i) next[i] += following * (mean[i] - next[i]);
  if (const auto axis = beyond(difference(next, first_), drift))
    return "its zero has drifted by " + amount(difference(next, first_), *axis) +
           "; the tool presses lightly for long, or the sensor is worn: start the workcell again with the "
           "tool "
           "in free air";
  known_ = next;
  return {};
}

Load ZeroPoint::take_off(const Load& load) const {
  return difference(load, *known_);
}

Load ZeroPoint::mean() const {
  Load result{};
  for (std::size_t i = 0; i < axes; ++i) result[i] = sum_[i] / count_;
  return result;
}

}  // namespace pal::runtime::drivers::force_torque
