#include "skills_pal/touch/touch.hpp"
#include "skills_pal/touch/touch_parts.hpp"
#include "touch_read_first_skill.hpp"

namespace pal::skills {

std::unique_ptr<runtime::Skill> touch_read_first_skill() {
  namespace order = touch_read_first;
  auto approach = std::make_shared<Approach>();
  return order::make_touch_read_first(
      std::make_unique<Advance<order::SM1Activities, order::Parameters, order::Motion, order::Zforce>>(
          approach),
      std::make_unique<ZForceSensor<order::LS1Activities, order::Wrench, order::Zforce>>(),
      std::make_unique<AlterPort<order::MC1Activities, order::Motion, order::Correction>>(),
      std::make_unique<Retreat<order::CM1Activities, order::Motion>>(approach));
}

}  // namespace pal::skills
