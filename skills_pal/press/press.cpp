#include "skills_pal/press/press.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "press_skill.hpp"
#include "skills_pal/modules/alter.hpp"
#include "skills_pal/modules/force_regulator.hpp"
#include "skills_pal/modules/lift_off.hpp"
#include "skills_pal/modules/overload.hpp"
#include "skills_pal/modules/retreat.hpp"
#include "skills_pal/modules/z_force.hpp"

namespace pal::skills {

namespace {

using namespace press;

// Starting to move shakes the tool, the more the faster: this is a force that only a contact gives.
constexpr double contact_at_rest = 1.0;   // N
constexpr double contact_a_speed = 0.03;  // N s/mm
constexpr double greatest_step = 0.8;     // mm in a cycle, while the force is regulated
// s in which it must come into its band and stay there, beyond the time asked for
constexpr double settling_limit = 30;

class Method final : public SM1Activities {
 public:
  explicit Method(std::shared_ptr<Approach> approach) : approach_(std::move(approach)) {}

  void start(const Parameters& parameters) override {
    if (parameters.force >= parameters.stop_force)
      throw runtime::ParameterError("force must be less than stop-force");
    contact_ = std::min(contact_at_rest + contact_a_speed * parameters.approach_speed, parameters.stop_force);
    refuse_overload(contact_, parameters.approach_speed, parameters.stiffness);
    parameters_ = parameters;
    approach_->start(parameters.approach_speed, parameters.search_distance);
    regulator_.start(parameters.force, parameters.stiffness, greatest_step, parameters.band / 2);
    touched_ = stopped_ = false;
    cycles_ = in_band_ = 0;
  }

  Motion advance(const Zforce& force) override {
    Motion motion;
    motion.dz = approach_->step_forward();
    regulator_.follow(force.value, motion.dz);
    return motion;
  }

  Motion regulate(const Zforce& force) override {
    ++cycles_;
    const bool within = std::abs(force.value - parameters_.force) <= parameters_.band;
    // A force that the regulator moves is not held.
    in_band_ = within && regulator_.holds() ? in_band_ + 1 : 0;
    if (cycles_ * alter_period > settling_limit + parameters_.time)
      throw std::runtime_error(
          "the force does not stay in its band: the band may be too narrow for this surface");
    Motion motion;
    motion.dz = regulator_.next(force.value, false);
    motion.ry = regulator_.turn();
    return motion;
  }

  Motion stand_still() override { return {}; }

  // Once met, met: a tool that has touched regulates, and one that pressed too hard gives up.
  bool decide_pc_contact(const Zforce& force) override {
    return touched_ = touched_ || force.value >= contact_;
  }
  bool decide_pc_stop(const Zforce& force) override {
    return stopped_ = stopped_ || force.greatest >= parameters_.stop_force;
  }
  bool decide_pc_held() override { return in_band_ * alter_period >= parameters_.time; }
  bool decide_pc_reach() override { return approach_->felt_reach(); }

 private:
  std::shared_ptr<Approach> approach_;
  ForceRegulator regulator_;
  Parameters parameters_;
  double contact_ = 0;  // N
  bool touched_ = false;
  bool stopped_ = false;
  int cycles_ = 0;   // since the tool touched
  int in_band_ = 0;  // cycles without a break in which the force was in its band
};

}  // namespace

std::unique_ptr<runtime::Skill> press_skill() {
  auto approach = std::make_shared<Approach>();
  return make_press(std::make_unique<Method>(approach), std::make_unique<ZForceSensor<LS1Activities>>(),
                    std::make_unique<AlterController<MC1Activities>>(Late::refuse),
                    std::make_unique<Retreat<CM1Activities>>(approach),
                    std::make_unique<LiftOff<CM2Activities>>());
}

}  // namespace pal::skills
