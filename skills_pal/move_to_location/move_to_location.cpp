#include "skills_pal/move_to_location/move_to_location.hpp"

#include "move_to_location_skill.hpp"
#include "skills_pal/modules/listing.hpp"

namespace pal::skills {

namespace {

using namespace move_to_location;

class Method final : public Listing<SM1Activities, Command> {
 public:
  using Listing::Listing;

  void list_motion() override {
    list().begin();
    list().set_speed(parameters().speed);
    list().add(parameters().straight ? Verb::move_straight : Verb::move, parameters().location);
  }
};

}  // namespace

std::unique_ptr<runtime::Skill> move_to_location_skill() {
  return make_listing<Method, SM2Activities, SM3Activities>(make_move_to_location,
                                                            std::make_shared<Method::List>());
}

}  // namespace pal::skills
