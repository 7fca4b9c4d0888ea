#include "skills_pal/move_cartesian/move_cartesian.hpp"

#include "move_cartesian_skill.hpp"
#include "skills_pal/modules/listing.hpp"

namespace pal::skills {

namespace {

using namespace move_cartesian;

class Method final : public Listing<SM1Activities, Command> {
 public:
  using Listing::Listing;

  void list_motion() override {
    list().begin();
    list().add(Verb::speed, 100).add(Verb::straight_speed, parameters().speed);
    Command& motion = list().add(Verb::straight_to, parameters().x, parameters().y, parameters().z).last();
    motion.d = parameters().o;
    motion.e = parameters().a;
    motion.f = parameters().t;
  }
};

}  // namespace

std::unique_ptr<runtime::Skill> move_cartesian_skill() {
  return make_listing<Method, SM2Activities, SM3Activities>(make_move_cartesian,
                                                            std::make_shared<Method::List>());
}

}  // namespace pal::skills
