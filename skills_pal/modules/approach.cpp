#include "skills_pal/modules/approach.hpp"

#include <algorithm>

namespace pal::skills {

void Approach::start(double speed, double reach) {
  step_ = speed * alter_period;
  reach_ = reach;
  gone_ = 0;
  stood_ = 0;
  home_ = false;
}

// The ends are set, not summed up to: sums of steps miss them by a rounding error.

double Approach::step_forward() {
  const double step = std::min(step_, reach_ - gone_);
  if (step <= 0) ++stood_;
  gone_ = step < step_ ? reach_ : gone_ + step;
  return step;
}

double Approach::step_back() {
  const double step = std::min(step_, gone_);
  home_ = step <= 0;
  gone_ = step < step_ ? 0 : gone_ - step;
  return -step;
}

}  // namespace pal::skills
