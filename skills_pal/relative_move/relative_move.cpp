#include "skills_pal/relative_move/relative_move.hpp"

#include "relative_move_skill.hpp"
#include "skills_pal/modules/listing.hpp"
#include "skills_pal/modules/val_turn.hpp"

namespace pal::skills {

namespace {

using namespace relative_move;

class Method final : public Listing<SM1Activities, Command> {
 public:
  using Listing::Listing;

  void list_motion() override {
    list().begin();
    const runtime::Text name("PALRELATIVE");
    const ValTurn turn = val_turn(parameters().rx, parameters().ry, parameters().rz);
    list().add(Verb::speed, 100).add(Verb::straight_speed, parameters().speed);
    Command& way =
        list().add(Verb::set_figures, name, parameters().dx, parameters().dy, parameters().dz).last();
    way.d = turn.o;
    way.e = turn.a;
    way.f = turn.t;
    list().add(Verb::straight_relative, name);
  }
};

}  // namespace

std::unique_ptr<runtime::Skill> relative_move_skill() {
  return make_listing<Method, SM2Activities, SM3Activities>(make_relative_move,
                                                            std::make_shared<Method::List>());
}

}  // namespace pal::skills
