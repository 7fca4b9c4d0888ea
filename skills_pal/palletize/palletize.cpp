#include "skills_pal/palletize/palletize.hpp"

#include "palletize_skill.hpp"
#include "skills_pal/modules/lower.hpp"

namespace pal::skills {

namespace {

using namespace palletize;

// VAL is taught it each time.
runtime::Text place(const Parameters&) {
  return runtime::Text("PALPLACE");
}

class Method final : public Lowering<SM1Activities, Command, place> {
 public:
  using Lowering::Lowering;

  void list_carry() override {
    const auto column = static_cast<double>(parameters().placed % parameters().columns);
    const auto row = static_cast<double>(parameters().placed / parameters().columns);
    const runtime::Text next = place(parameters());
    begin_above();
    list().begin();
    list().set_speed(parameters().speed).add(Verb::set, next).last().second = parameters().corner;
    list()
        .add(Verb::shift, next, column * parameters().pitch, row * parameters().pitch, 0)
        .add(Verb::approach, next, parameters().approach);
  }

  bool decide_pc_full() override { return parameters().placed >= parameters().rows * parameters().columns; }
};

}  // namespace

std::unique_ptr<runtime::Skill> palletize_skill() {
  auto list = std::make_shared<Method::List>();
  return make_listing<Method, SM2Activities, SM3Activities>(
      make_palletize, list, std::make_unique<ZForceSensor<LS1Activities>>(),
      std::make_unique<GripSensor<LS3Activities>>(),
      std::make_unique<LiftAgain<CM4Activities, Command, place>>(list));
}

}  // namespace pal::skills
