// MC1 of alter.pal.
#pragma once

#include "skills_pal/modules/signature.hpp"

namespace pal::skills {

/// What a skill asks for goes to the ALTER port as it is; without a motion in time the tool stays where it
/// is.
template <class Interface>
class AlterController final : public Interface {
  using Motion = ArgumentOf<&Interface::obey>;
  using Correction = ResultOf<&Interface::obey>;

 public:
  Correction obey(const Motion& motion) override { return Correction::from_fields(motion.fields()); }
  Correction hold() override { return {}; }
};

}  // namespace pal::skills
