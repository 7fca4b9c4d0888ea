#include "skills_pal/pick_at_location/pick_at_location.hpp"

#include "pick_at_location_skill.hpp"
#include "skills_pal/modules/gripper.hpp"
#include "skills_pal/modules/listing.hpp"

namespace pal::skills {

namespace {

using namespace pick_at_location;

class Method final : public Listing<SM1Activities, Command> {
 public:
  using Listing::Listing;

  void list_grasp() override {
    list().begin();
    list()
        .set_speed(parameters().speed)
        .add(Verb::open_hand)
        .add(Verb::approach, parameters().location, parameters().approach)
        .add(Verb::move_straight, parameters().location)
        .add(Verb::close_hand)
        .add(Verb::delay, parameters().grip_delay);
  }

  void list_lift() override {
    list().begin();
    list().add(Verb::depart_straight, parameters().approach);
  }

  bool decide_pc_holding(const Grip& grip) override { return grip.holding; }
};

class Return final : public Listing<CM4Activities, Command> {
 public:
  using Listing::Listing;

  void list_return() override {
    list().begin();
    list().add(Verb::open_hand).add(Verb::depart_straight, parameters().approach);
  }
};

class Open final : public Listing<CM5Activities, Command> {
 public:
  using Listing::Listing;

  void list_open() override {
    list().begin();
    list().add(Verb::open_hand);
  }
};

}  // namespace

std::unique_ptr<runtime::Skill> pick_at_location_skill() {
  auto list = std::make_shared<Method::List>();
  return make_listing<Method, SM2Activities, SM3Activities>(
      make_pick_at_location, list, std::make_unique<GripSensor<LS3Activities>>(),
      std::make_unique<Return>(list), std::make_unique<Open>(list));
}

}  // namespace pal::skills
