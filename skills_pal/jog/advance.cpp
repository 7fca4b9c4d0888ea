#include "skills_pal/jog/advance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pal::skills {
namespace {

constexpr double speeding_up = 3;  // cycles

}  // namespace

void JogAdvance::start(const Axes& most, const Axes& step) {
  *this = {};
  most_ = most;
  step_ = step;
  steps_ = std::any_of(step.begin(), step.end(), [](double way) { return way > 0; });
}

Axes JogAdvance::next(const Axes& wanted) {
  if (steps_) return along_step(wanted);
  for (std::size_t i = 0; i < speed_.size(); ++i) {
    const double change = std::clamp(wanted[i], -1.0, 1.0) * most_[i] - speed_[i];
    const double greatest = most_[i] / speeding_up;
    speed_[i] += std::clamp(change, -greatest, greatest);
  }
  return speed_;
}

Axes JogAdvance::along_step(const Axes& wanted) {
  if (std::all_of(whole_.begin(), whole_.end(), [](double way) { return way == 0; }))
    for (std::size_t i = 0; i < whole_.size(); ++i) whole_[i] = std::clamp(wanted[i], -1.0, 1.0) * step_[i];
  double most = std::numeric_limits<double>::infinity();  // part of the step in a cycle
  for (std::size_t i = 0; i < whole_.size(); ++i)
    if (whole_[i] != 0) most = std::min(most, most_[i] / std::abs(whole_[i]));
  if (!std::isfinite(most) || there_) return {};
  const double left = 1 - gone_;
  const double change = most / speeding_up;
  // The greatest rate from which equal changes, one a cycle, come to rest within what is left.
  const double braking = change * (std::sqrt(0.25 + 2 * left / change) - 0.5);
  rate_ = std::min({rate_ + change, most, std::max(braking, change / 2), left});
  gone_ = rate_ < left ? gone_ + rate_ : 1;
  there_ = gone_ >= 1;
  Axes way{};
  for (std::size_t i = 0; i < way.size(); ++i) way[i] = rate_ * whole_[i];
  return way;
}

}  // namespace pal::skills
