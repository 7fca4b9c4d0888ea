#include "skills_pal/place_at_location/place_at_location.hpp"

#include <utility>

#include "skills_pal/modules/lower.hpp"
#include "skills_pal/place_at_location/by_sensor.hpp"

namespace pal::skills {

namespace {

using namespace place_at_location;

runtime::Text place(const Parameters& parameters) {
  return parameters.location;
}

class Method final : public Lowering<SM1Activities, Command, place> {
 public:
  using Lowering::Lowering;

  void list_carry() override {
    begin_above();
    list().begin();
    list().set_speed(parameters().speed).add(Verb::approach, parameters().location, parameters().approach);
  }
};

}  // namespace

std::unique_ptr<runtime::Skill> place_at_location_skill() {
  return place_at_location_by(std::make_unique<ZForceSensor<LS1Activities>>());
}

std::unique_ptr<runtime::Skill> place_at_location_by(std::unique_ptr<LS1Activities> force_sensor) {
  auto list = std::make_shared<Method::List>();
  return make_listing<Method, SM2Activities, SM3Activities>(
      make_place_at_location, list, std::move(force_sensor), std::make_unique<GripSensor<LS3Activities>>(),
      std::make_unique<LiftAgain<CM4Activities, Command, place>>(list));
}

}  // namespace pal::skills
