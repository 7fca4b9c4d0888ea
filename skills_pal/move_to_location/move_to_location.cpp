#include "skills_pal/move_to_location/move_to_location.hpp"

#include "move_to_location_skill.hpp"
#include "skills_pal/modules/commands.hpp"

namespace pal::skills {

namespace {

using namespace move_to_location;

class Method final : public SM1Activities {
 public:
  explicit Method(std::shared_ptr<CommandList<Command>> list) : list_(std::move(list)) {}

  void start(const Parameters& parameters) override { parameters_ = parameters; }

  void list_motion() override {
    list_->begin();
    list_->set_speed(parameters_.speed);
    list_->add(parameters_.straight ? Verb::move_straight : Verb::move, parameters_.location);
  }

 private:
  std::shared_ptr<CommandList<Command>> list_;
  Parameters parameters_;
};

}  // namespace

std::unique_ptr<runtime::Skill> move_to_location_skill() {
  auto list = std::make_shared<CommandList<Command>>();
  return make_move_to_location(std::make_unique<Method>(list),
                               std::make_unique<Commands<SM2Activities>>(list),
                               std::make_unique<Report<SM3Activities>>());
}

}  // namespace pal::skills
