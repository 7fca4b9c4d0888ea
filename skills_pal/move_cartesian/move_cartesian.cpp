#include "skills_pal/move_cartesian/move_cartesian.hpp"

#include "move_cartesian_skill.hpp"
#include "skills_pal/modules/commands.hpp"

namespace pal::skills {

namespace {

using namespace move_cartesian;

class Method final : public SM1Activities {
 public:
  explicit Method(std::shared_ptr<CommandList<Command>> list) : list_(std::move(list)) {}

  void start(const Parameters& parameters) override { parameters_ = parameters; }

  void list_motion() override {
    list_->begin();
    list_->add(Verb::speed, 100).add(Verb::straight_speed, parameters_.speed);
    Command& motion = list_->add(Verb::straight_to, parameters_.x, parameters_.y, parameters_.z).last();
    motion.d = parameters_.o;
    motion.e = parameters_.a;
    motion.f = parameters_.t;
  }

 private:
  std::shared_ptr<CommandList<Command>> list_;
  Parameters parameters_;
};

}  // namespace

std::unique_ptr<runtime::Skill> move_cartesian_skill() {
  auto list = std::make_shared<CommandList<Command>>();
  return make_move_cartesian(std::make_unique<Method>(list), std::make_unique<Commands<SM2Activities>>(list),
                             std::make_unique<Report<SM3Activities>>());
}

}  // namespace pal::skills
