#include "skills_pal/touch/touch.hpp"

#include "skills_pal/modules/alter.hpp"
#include "skills_pal/modules/retreat.hpp"
#include "skills_pal/modules/z_force.hpp"
#include "skills_pal/touch/advance.hpp"
#include "touch_skill.hpp"

namespace pal::skills {

namespace {

class Method final : public Advance<touch::SM1Activities> {
 public:
  using Advance::Advance;
  touch::Motion stand_still() override { return {}; }
};

}  // namespace

std::unique_ptr<runtime::Skill> touch_skill() {
  auto approach = std::make_shared<Approach>();
  return touch::make_touch(std::make_unique<Method>(approach),
                           std::make_unique<ZForceSensor<touch::LS1Activities>>(),
                           std::make_unique<AlterController<touch::MC1Activities>>(Late::refuse),
                           std::make_unique<Retreat<touch::CM1Activities>>(approach));
}

}  // namespace pal::skills
