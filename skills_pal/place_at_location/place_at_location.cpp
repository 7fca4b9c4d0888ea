#include "skills_pal/place_at_location/place_at_location.hpp"

#include <algorithm>

#include "place_at_location_skill.hpp"
#include "skills_pal/modules/commands.hpp"
#include "skills_pal/modules/gripper.hpp"
#include "skills_pal/modules/z_force.hpp"

namespace pal::skills {

namespace {

using namespace place_at_location;
using List = CommandList<Command>;

// The fingers reach 10 mm below the tip, and what stands at the place is met by the part's underside. With a
// part that is held at its middle and is 50 mm high, that leaves 15 mm until the fingers, too, would grip
// what stands there.
constexpr double step = 14;    // mm
constexpr double contact = 5;  // N: more than the tool's weight shifts by when it comes to rest

class Method final : public SM1Activities {
 public:
  explicit Method(std::shared_ptr<List> list) : list_(std::move(list)) {}

  void start(const Parameters& parameters) override {
    parameters_ = parameters;
    height_ = parameters.approach;
  }

  void list_carry() override {
    list_->begin();
    list_->set_speed(parameters_.speed).add(Verb::approach, parameters_.location, parameters_.approach);
  }

  // Apart from the way there: what the tool meets here stands at the place.
  void list_step() override {
    height_ = parameters_.feel ? std::max(0.0, height_ - step) : 0;
    list_->begin();
    if (height_ > 0) {
      list_->add(Verb::approach_straight, parameters_.location, height_);
    } else {
      list_->add(Verb::move_straight, parameters_.location);
    }
  }

  void list_release() override {
    list_->begin();
    list_->add(Verb::open_hand)
        .add(Verb::delay, parameters_.grip_delay)
        .add(Verb::depart_straight, parameters_.approach);
  }

  bool decide_pc_holding(const Grip& grip) override { return grip.holding; }
  bool decide_pc_down() override { return height_ <= 0; }
  // At the location the part may press: that is what it is put down on.
  bool decide_pc_blocked(const Zforce& force) override { return height_ > 0 && force.value >= contact; }

 private:
  std::shared_ptr<List> list_;
  Parameters parameters_;
  double height_ = 0;  // mm above the location, as it was commanded
};

class Return final : public CM4Activities {
 public:
  explicit Return(std::shared_ptr<List> list) : list_(std::move(list)) {}

  void start(const Parameters& parameters) override { parameters_ = parameters; }
  void list_return() override {
    list_->begin();
    list_->add(Verb::calibrate).add(Verb::approach_straight, parameters_.location, parameters_.approach);
  }

 private:
  std::shared_ptr<List> list_;
  Parameters parameters_;
};

}  // namespace

std::unique_ptr<runtime::Skill> place_at_location_skill() {
  auto list = std::make_shared<List>();
  return make_place_at_location(
      std::make_unique<Method>(list), std::make_unique<Commands<SM2Activities>>(list),
      std::make_unique<Report<SM3Activities>>(), std::make_unique<ZForceSensor<LS1Activities>>(),
      std::make_unique<GripSensor<LS3Activities>>(), std::make_unique<Return>(list));
}

}  // namespace pal::skills
