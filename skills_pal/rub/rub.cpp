#include "skills_pal/rub/rub.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "rub_skill.hpp"
#include "skills_pal/modules/alter.hpp"
#include "skills_pal/modules/approach.hpp"
#include "skills_pal/modules/force_regulator.hpp"
#include "skills_pal/modules/lift_off.hpp"
#include "skills_pal/modules/overload.hpp"
#include "skills_pal/modules/z_force.hpp"

namespace pal::skills {

namespace {

using namespace rub;

constexpr double counts = 20;      // a newton
constexpr int landed_cycles = 10;  // in the band, without a break: the tool has landed
constexpr int cycles_to_speed =
    20;  // a slope that begins at once is felt 60 ms later, one that begins slowly is learned
constexpr double farthest = 20;  // mm: the surface is within that

class Method final : public SM1Activities {
 public:
  void start(const Parameters& parameters) override {
    refuse(parameters);
    parameters_ = parameters;
    hardest_ = -parameters.greatest_force / counts;
    softest_ = -parameters.least_force / counts;
    const double angle = parameters.direction * std::numbers::pi / 180;
    along_x_ = std::cos(angle);
    along_y_ = std::sin(angle);
    regulator_.start((hardest_ + softest_) / 2, parameters.stiffness, parameters.vertical);
    gone_ = sunk_ = 0;
    in_band_ = sliding_ = 0;
    stopped_ = failed_ = false;
  }

  Motion slide(const Zforce& force) override {
    Motion motion;
    const double step = parameters_.band_rule ? parameters_.speed : start_slowly(force.value);
    motion.dz = parameters_.band_rule ? band_rule(force.value) : regulator_.next(force.value, sliding_ > 0);
    motion.ry = regulator_.turn();
    // The end is set, not summed up to: sums of steps miss it by a rounding error.
    const double distance = parameters_.distance * 10;
    const double part = std::min(step, distance - gone_);
    gone_ = part < step ? distance : gone_ + part;
    motion.dx = along_x_ * part;
    motion.dy = along_y_ * part;
    return motion;
  }

  Motion stand_still() override { return {}; }

  // Once met, met: what is decided on a force must not be forgotten when the tool springs back.
  bool decide_pc_error(const Zforce& force) override {
    return failed_ = failed_ || force.greatest * counts >= parameters_.error_force;
  }
  bool decide_pc_stop(const Zforce& force) override {
    return stopped_ = stopped_ || force.greatest * counts >= parameters_.stop_force;
  }
  bool decide_pc_end() override { return gone_ >= parameters_.distance * 10; }

 private:
  static void refuse(const Parameters& parameters) {
    if (parameters.greatest_force >= parameters.least_force)
      throw runtime::ParameterError(
          "greatest-force must be below least-force: both are negative when the tool presses");
    if (parameters.stop_force <= -parameters.greatest_force)
      throw runtime::ParameterError("stop-force must be greater than the band's greatest force");
    if (parameters.error_force < parameters.stop_force)
      throw runtime::ParameterError("error-force must not be less than stop-force");
    if (parameters.speed <= 0)
      throw runtime::ParameterError("speed must be greater than 0: the distance would never be gone");
    if (parameters.vertical <= 0)
      throw runtime::ParameterError(
          "vertical must be greater than 0: the tool would never come to the surface");
    if (parameters.band_rule)
      refuse_overload(-parameters.least_force / counts, parameters.vertical / alter_period,
                      parameters.stiffness);
  }

  // The thesis's rule (5.4.2).
  double band_rule(double force) const {
    if (force > hardest_) return -parameters_.vertical;
    return force < softest_ ? parameters_.vertical : 0;
  }

  // Nothing along the surface until the tool has landed on it; then evenly up to the speed.
  double start_slowly(double force) {
    if (sliding_ == 0) {
      in_band_ = force >= softest_ && force <= hardest_ ? in_band_ + 1 : 0;
      sunk_ = std::max(sunk_, regulator_.gone());
      if (sunk_ > farthest) throw std::runtime_error("no surface within 20 mm");
      if (in_band_ < landed_cycles) return 0;
    }
    sliding_ = std::min(sliding_ + 1, cycles_to_speed);
    return parameters_.speed * sliding_ / cycles_to_speed;
  }

  Parameters parameters_;
  ForceRegulator regulator_;
  double hardest_ = 0, softest_ = 0;  // N, positive when the tool presses
  double along_x_ = 1, along_y_ = 0;
  double gone_ = 0;  // mm along the surface
  double sunk_ = 0;  // mm, most towards the surface before the tool landed
  int in_band_ = 0;  // cycles, before the tool slides
  int sliding_ = 0;  // cycles, no more than cycles_to_speed
  bool stopped_ = false, failed_ = false;
};

}  // namespace

std::unique_ptr<runtime::Skill> rub_skill() {
  return make_rub(std::make_unique<Method>(), std::make_unique<ZForceSensor<LS1Activities>>(),
                  std::make_unique<AlterController<MC1Activities>>(Late::refuse),
                  std::make_unique<LiftOff<CM2Activities>>());
}

}  // namespace pal::skills
