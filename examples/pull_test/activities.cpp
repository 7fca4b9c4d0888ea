// What the PAL leaves to be written by hand: a few lines a module.
#include "activities.hpp"

#include <algorithm>
#include <atomic>

#include "pull_test_skill.hpp"

using namespace pal::skills::pull_test;

namespace {

constexpr double beat = 0.010;  // s between two steps of the axis
constexpr double counts_per_newton = 40;

/// Where the gripper was told to be: shared by the method and its contingency, which never run at the same
/// time.
struct Way {
  double step = 0;  // mm
  double gone = 0;  // mm
};

class Method final : public PullerActivities {
 public:
  explicit Method(std::shared_ptr<Way> way) : way_(std::move(way)) {}

  void start(const Parameters& parameters) override {
    parameters_ = parameters;
    *way_ = {parameters.speed * beat, 0};
    unsure_ = false;
  }
  /// Something is late, so what the plug does is not known in time: the skill gives up by its own
  /// contingency.
  bool promise_broken(const pal::runtime::BrokenPromise&) override { return unsure_ = true; }
  Step draw() override {
    const double step = std::min(way_->step, parameters_.distance - way_->gone);
    way_->gone += step;
    return {step};
  }
  Step stop() override { return {0}; }
  bool decide_seated(const Pull& pull) override { return pull.value >= parameters_.test_force; }
  bool decide_loose() override { return unsure_ || way_->gone >= parameters_.distance; }

 private:
  std::shared_ptr<Way> way_;
  Parameters parameters_;
  std::atomic<bool> unsure_ = false;  // in real time the skill is told while an activity is at work
};

class Scale final : public TensionActivities {
 public:
  Pull scale(const Reading& reading) override {
    return {static_cast<double>(reading.value) / counts_per_newton};
  }
};

class Rest final : public AxisActivities {
 public:
  Step rest() override { return {0}; }
};

class Back final : public PushBackActivities {
 public:
  explicit Back(std::shared_ptr<Way> way) : way_(std::move(way)) {}
  void start(const Parameters&) override { arrived_ = false; }
  Step push() override {
    arrived_ = way_->gone <= 0;  // one more step, of 0, says that the last one was made
    const double step = std::min(way_->step, way_->gone);
    way_->gone -= step;
    return {-step};
  }
  bool decide_back() override { return arrived_; }

 private:
  std::shared_ptr<Way> way_;
  bool arrived_ = false;
};

}  // namespace

std::unique_ptr<pal::runtime::Skill> pull_test_skill() {
  auto way = std::make_shared<Way>();
  return make_pull_test(std::make_unique<Method>(way), std::make_unique<Scale>(), std::make_unique<Rest>(),
                        std::make_unique<Back>(way));
}
