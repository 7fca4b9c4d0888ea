#include "skills_pal/palletize/palletize.hpp"

#include <stdexcept>

#include "palletize_skill.hpp"
#include "skills_pal/modules/commands.hpp"
#include "skills_pal/modules/gripper.hpp"

namespace pal::skills {

namespace {

using namespace palletize;
using List = CommandList<Command>;

class Method final : public SM1Activities {
 public:
  explicit Method(std::shared_ptr<List> list) : list_(std::move(list)) {}

  void start(const Parameters& parameters) override { parameters_ = parameters; }

  void list_placing() override {
    const auto column = static_cast<double>(parameters_.placed % parameters_.columns);
    const auto row = static_cast<double>(parameters_.placed / parameters_.columns);
    const runtime::Text place("PALPLACE");
    list_->begin();
    list_->set_speed(parameters_.speed).add(Verb::set, place).last().second = parameters_.corner;
    list_->add(Verb::shift, place, column * parameters_.pitch, row * parameters_.pitch, 0)
        .add(Verb::approach, place, parameters_.approach)
        .add(Verb::move_straight, place)
        .add(Verb::open_hand)
        .add(Verb::delay, parameters_.grip_delay)
        .add(Verb::depart_straight, parameters_.approach);
  }

  void complain() override { throw std::runtime_error("the fingers hold nothing to put down"); }

  bool decide_pc_full() override { return parameters_.placed >= parameters_.rows * parameters_.columns; }
  bool decide_pc_holding(const Grip& grip) override { return grip.holding; }

 private:
  std::shared_ptr<List> list_;
  Parameters parameters_;
};

}  // namespace

std::unique_ptr<runtime::Skill> palletize_skill() {
  auto list = std::make_shared<List>();
  return make_palletize(std::make_unique<Method>(list), std::make_unique<Commands<SM2Activities>>(list),
                        std::make_unique<Report<SM3Activities>>(),
                        std::make_unique<GripSensor<LS3Activities>>());
}

}  // namespace pal::skills
