#include "skills_pal/pick_at_location/pick_at_location.hpp"

#include "pick_at_location_skill.hpp"
#include "skills_pal/modules/commands.hpp"
#include "skills_pal/modules/gripper.hpp"

namespace pal::skills {

namespace {

using namespace pick_at_location;
using List = CommandList<Command>;

class Method final : public SM1Activities {
 public:
  explicit Method(std::shared_ptr<List> list) : list_(std::move(list)) {}

  void start(const Parameters& parameters) override { parameters_ = parameters; }

  void list_grasp() override {
    list_->begin();
    list_->set_speed(parameters_.speed)
        .add(Verb::open_hand)
        .add(Verb::approach, parameters_.location, parameters_.approach)
        .add(Verb::move_straight, parameters_.location)
        .add(Verb::close_hand)
        .add(Verb::delay, parameters_.grip_delay);
  }

  void list_lift() override {
    list_->begin();
    list_->add(Verb::depart_straight, parameters_.approach);
  }

  bool decide_pc_holding(const Grip& grip) override { return grip.holding; }

 private:
  std::shared_ptr<List> list_;
  Parameters parameters_;
};

class Return final : public CM4Activities {
 public:
  explicit Return(std::shared_ptr<List> list) : list_(std::move(list)) {}

  void start(const Parameters& parameters) override { approach_ = parameters.approach; }
  void list_return() override {
    list_->begin();
    list_->add(Verb::open_hand).add(Verb::depart_straight, approach_);
  }

 private:
  std::shared_ptr<List> list_;
  double approach_ = 0;
};

}  // namespace

std::unique_ptr<runtime::Skill> pick_at_location_skill() {
  auto list = std::make_shared<List>();
  return make_pick_at_location(std::make_unique<Method>(list),
                               std::make_unique<Commands<SM2Activities>>(list),
                               std::make_unique<Report<SM3Activities>>(),
                               std::make_unique<GripSensor<LS3Activities>>(), std::make_unique<Return>(list));
}

}  // namespace pal::skills
