#include "skills_pal/touch/touch.hpp"

#include "skills_pal/touch/touch_parts.hpp"
#include "touch_skill.hpp"

namespace pal::skills {

namespace {

class Method final : public Advance<touch::SM1Activities, touch::Parameters, touch::Motion, touch::Zforce> {
 public:
  using Advance::Advance;
  touch::Motion stand_still() override { return {}; }
};

}  // namespace

std::unique_ptr<runtime::Skill> touch_skill() {
  auto approach = std::make_shared<Approach>();
  return touch::make_touch(
      std::make_unique<Method>(approach),
      std::make_unique<ZForceSensor<touch::LS1Activities, touch::Wrench, touch::Zforce>>(),
      std::make_unique<AlterPort<touch::MC1Activities, touch::Motion, touch::Correction>>(),
      std::make_unique<Retreat<touch::CM1Activities, touch::Motion>>(approach));
}

}  // namespace pal::skills
