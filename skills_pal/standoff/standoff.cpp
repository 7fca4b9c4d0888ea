#include "skills_pal/standoff/standoff.hpp"

#include <cmath>
#include <stdexcept>

#include "skills_pal/modules/alter.hpp"
#include "skills_pal/modules/looking.hpp"
#include "skills_pal/modules/nearest_point.hpp"
#include "standoff_skill.hpp"

namespace pal::skills {

namespace {

using namespace standoff;

constexpr int looks = 8;       // that are averaged
constexpr double fine = 0.03;  // mm: what going on would not make better
constexpr int good_rounds = 3;
// A surface that does not stay where it is is not followed for ever.
constexpr int most_rounds = 10;
constexpr double most_way = 700;  // mm: twice from one end of what the range finder sees to the other

class Method final : public SM1Activities {
 public:
  void start(const Parameters& parameters) override {
    parameters_ = parameters;
    looking_.start(parameters.speed, 0);
    sum_ = 0;
    count_ = 0;
    within_ = false;
    rounds_ = 0;
    gone_ = 0;
  }

  Motion step(const Distance& distance) override {
    if (looking_.fresh_look(distance.taken)) look(distance.value);
    Motion motion;
    motion.dz = looking_.step().dz;
    return motion;
  }

  Motion stand_still() override { return {}; }
  bool decide_pc_seen(const Distance& distance) override { return distance.seen; }
  bool decide_pc_there() override { return within_; }

 private:
  void look(double distance) {
    sum_ += distance;
    if (++count_ < looks) return;
    const double error = sum_ / count_ - parameters_.distance;
    sum_ = 0;
    count_ = 0;
    // A little further if that still makes it better.
    const bool best = std::abs(error) <= fine || ++rounds_ > good_rounds;
    within_ = std::abs(error) <= parameters_.tolerance && best;
    if (within_) return;
    gone_ += std::abs(error);
    if (rounds_ > most_rounds || gone_ > most_way)
      throw std::runtime_error("the surface does not stay within the tolerance of its distance");
    Way way;
    way.dz = error;
    looking_.go(way);
  }

  Parameters parameters_;
  Looking looking_;
  double sum_ = 0;   // mm
  double gone_ = 0;  // mm, there and back
  int count_ = 0;
  int rounds_ = 0;
  bool within_ = false;
};

}  // namespace

std::unique_ptr<runtime::Skill> standoff_skill() {
  return make_standoff(std::make_unique<Method>(), std::make_unique<NearestPointSensor<LS2Activities>>(),
                       std::make_unique<AlterController<MC1Activities>>(Late::hold));
}

}  // namespace pal::skills
