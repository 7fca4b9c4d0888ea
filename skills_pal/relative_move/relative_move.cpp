#include "skills_pal/relative_move/relative_move.hpp"

#include "relative_move_skill.hpp"
#include "skills_pal/modules/commands.hpp"
#include "skills_pal/modules/val_turn.hpp"

namespace pal::skills {

namespace {

using namespace relative_move;

class Method final : public SM1Activities {
 public:
  explicit Method(std::shared_ptr<CommandList<Command>> list) : list_(std::move(list)) {}

  void start(const Parameters& parameters) override { parameters_ = parameters; }

  void list_motion() override {
    list_->begin();
    const runtime::Text name("PALRELATIVE");
    const ValTurn turn = val_turn(parameters_.rx, parameters_.ry, parameters_.rz);
    list_->add(Verb::speed, 100).add(Verb::straight_speed, parameters_.speed);
    Command& way = list_->add(Verb::set_figures, name, parameters_.dx, parameters_.dy, parameters_.dz).last();
    way.d = turn.o;
    way.e = turn.a;
    way.f = turn.t;
    list_->add(Verb::straight_relative, name);
  }

 private:
  std::shared_ptr<CommandList<Command>> list_;
  Parameters parameters_;
};

}  // namespace

std::unique_ptr<runtime::Skill> relative_move_skill() {
  auto list = std::make_shared<CommandList<Command>>();
  return make_relative_move(std::make_unique<Method>(list), std::make_unique<Commands<SM2Activities>>(list),
                            std::make_unique<Report<SM3Activities>>());
}

}  // namespace pal::skills
