#include "skills_pal/registry.hpp"

#include <array>

#include "skills_pal/press/press.hpp"
#include "skills_pal/rub/rub.hpp"
#include "skills_pal/touch/touch.hpp"

namespace pal::skills {

namespace {

constexpr std::array skills{RegisteredSkill{"press", press_skill, "press/press.pal", "workcell.pal"},
                            RegisteredSkill{"rub", rub_skill, "rub/rub.pal", "workcell.pal"},
                            RegisteredSkill{"touch", touch_skill, "touch/touch.pal", "workcell.pal"},
                            RegisteredSkill{"touch-read-first", touch_read_first_skill,
                                            "touch/touch_read_first.pal", "workcell.pal"}};

}  // namespace

std::span<const RegisteredSkill> registered_skills() {
  return skills;
}

std::unique_ptr<runtime::Skill> make_skill(std::string_view name) {
  for (const RegisteredSkill& skill : skills) {
    if (skill.name == name) return skill.make();
  }
  return nullptr;
}

}  // namespace pal::skills
