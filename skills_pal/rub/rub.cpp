#include "skills_pal/rub/rub.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
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
constexpr double farthest = 20;                         // mm: the surface is within that
constexpr double contact = 0.4;                         // N: less is felt in the air, too
constexpr int most_in_air = 5;                          // cycles: a surface that goes on is met again by then
constexpr int calm_cycles = 5;                          // in the band at the end of the way, without a motion
constexpr double landing_limit = 10, ending_limit = 2;  // s
constexpr double down_limit = 60;  // s: a band that is too soft hardly brings the tool down

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
    in_band_ = sliding_ = down_ = landing_ = in_air_ = ending_ = calm_ = 0;
    stopped_ = failed_ = false;
  }

  Motion slide(const Zforce& force) override {
    if (gone_ >= parameters_.distance * 10) return come_to_rest(force.value);
    if (sliding_ > 0) stay_on_the_surface(force.value);
    Motion motion;
    const double step = start_slowly(force.value);
    motion.dz = towards_band(force.value, sliding_ > 0);
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
  bool decide_pc_end() override { return calm_ >= calm_cycles; }

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

  double towards_band(double force, bool sliding) {
    return parameters_.band_rule ? band_rule(force) : regulator_.next(force, sliding);
  }
  bool within(double force) const { return force >= softest_ && force <= hardest_; }

  // At the end of the way the tool stands. The skill ends when it presses as asked after its last motion.
  Motion come_to_rest(double force) {
    if (++ending_ * alter_period > ending_limit) {
      std::array<char, 120> text{};
      std::snprintf(text.data(), text.size(),
                    "at the end of the way the tool presses with %.1f N: not in its band", force);
      throw std::runtime_error(text.data());
    }
    Motion motion;
    calm_ = within(force) ? calm_ + 1 : 0;
    if (calm_ > 0) {
      regulator_.follow(force, 0);
    } else {
      motion.dz = towards_band(force, false);
      motion.ry = regulator_.turn();
    }
    return motion;
  }

  void stay_on_the_surface(double force) {
    in_air_ = force < contact ? in_air_ + 1 : 0;
    if (in_air_ >= most_in_air)
      throw std::runtime_error("the surface has ended: nothing was felt for 140 ms");
  }

  // The thesis's rule (5.4.2).
  double band_rule(double force) const {
    if (force > hardest_) return -parameters_.vertical;
    return force < softest_ ? parameters_.vertical : 0;
  }

  // Nothing along the surface until the tool has landed on it; then evenly up to the speed. The thesis's rule
  // slides as soon as it touches.
  double start_slowly(double force) {
    if (sliding_ == 0 && !landed(force)) return 0;
    sliding_ = std::min(sliding_ + 1, cycles_to_speed);
    return parameters_.band_rule ? parameters_.speed : parameters_.speed * sliding_ / cycles_to_speed;
  }

  bool landed(double force) {
    if (force >= contact) ++landing_;
    if (parameters_.band_rule) {
      sunk_ += band_rule(force);
      in_band_ = landing_ > 0 ? landed_cycles : 0;
    } else {
      sunk_ = std::max(sunk_, regulator_.gone());
      in_band_ = force >= std::max(softest_, contact) && force <= hardest_ ? in_band_ + 1 : 0;
    }
    if (sunk_ > farthest) throw std::runtime_error("no surface within 20 mm");
    if (++down_ * alter_period > down_limit)
      throw std::runtime_error("the tool has not landed within 60 s: is the band too soft to bring it down?");
    if (landing_ * alter_period > landing_limit)
      throw std::runtime_error("the tool does not come to rest in its band: is the stiffness right?");
    return in_band_ >= landed_cycles;
  }

  Parameters parameters_;
  ForceRegulator regulator_;
  double hardest_ = 0, softest_ = 0;  // N, positive when the tool presses
  double along_x_ = 1, along_y_ = 0;
  double gone_ = 0;  // mm along the surface
  double sunk_ = 0;  // mm, most towards the surface before the tool landed
  int in_band_ = 0;  // cycles, before the tool slides
  int sliding_ = 0;  // cycles, no more than cycles_to_speed
  int down_ = 0;     // cycles before it slides
  int landing_ = 0;  // of those, since it touched
  int in_air_ = 0;   // cycles, one after the other
  int ending_ = 0;   // cycles at the end of the way
  int calm_ = 0;     // of those, in the band without a motion
  bool stopped_ = false, failed_ = false;
};

}  // namespace

std::unique_ptr<runtime::Skill> rub_skill() {
  return make_rub(std::make_unique<Method>(), std::make_unique<ZForceSensor<LS1Activities>>(),
                  std::make_unique<AlterController<MC1Activities>>(Late::refuse),
                  std::make_unique<LiftOff<CM2Activities>>());
}

}  // namespace pal::skills
