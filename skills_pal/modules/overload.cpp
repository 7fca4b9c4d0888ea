#include "skills_pal/modules/overload.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "pal/runtime/skill.hpp"

namespace pal::skills {

void refuse_overload(double threshold, double speed, double stiffness) {
  const double force = threshold + reaction * speed * stiffness;
  if (force <= greatest_force) return;
  std::array<char, 240> text{};
  std::snprintf(text.data(), text.size(),
                "at %g mm/s a contact of %g N/mm is felt too late: the tool would press with up to %.0f N, "
                "more than the %g N that the "
                "sensor bears; with %g N as its threshold it may go at %.3g mm/s",
                speed, stiffness, force, greatest_force, threshold,
                std::floor(10 * (greatest_force - threshold) / (reaction * stiffness)) / 10);
  throw runtime::ParameterError(text.data());
}

}  // namespace pal::skills
