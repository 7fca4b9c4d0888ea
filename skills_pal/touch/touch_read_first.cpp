// The activities of touch in the order of the thesis, which reads the condition too early.
#include "skills_pal/modules/alter.hpp"
#include "skills_pal/modules/retreat.hpp"
#include "skills_pal/modules/z_force.hpp"
#include "skills_pal/touch/advance.hpp"
#include "skills_pal/touch/touch.hpp"
#include "touch_read_first_skill.hpp"

namespace pal::skills {

std::unique_ptr<runtime::Skill> touch_read_first_skill() {
  namespace order = touch_read_first;
  auto approach = std::make_shared<Approach>();
  return order::make_touch_read_first(std::make_unique<Advance<order::SM1Activities>>(approach),
                                      std::make_unique<ZForceSensor<order::LS1Activities>>(),
                                      std::make_unique<AlterController<order::MC1Activities>>(Late::refuse),
                                      std::make_unique<Retreat<order::CM1Activities>>(approach));
}

}  // namespace pal::skills
