// Tests three plugs on a bench that is a few lines long: one is seated, one is loose, and of one the gauge
// gets slow.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "activities.hpp"
#include "pal/runtime/dispatcher.hpp"
#include "pal/runtime/still_world.hpp"
#include "pull_test_devices.hpp"

using namespace pal::runtime;
using namespace pal::skills::pull_test;

namespace {

/// A plug on a spring that lets go beyond a force.
struct Plug {
  double stiffness = 0;  // N/mm
  double holds = 0;      // N
  double gripper = 0;    // mm
  bool out = false;

  double pull() const { return out ? 0 : stiffness * std::max(0.0, gripper); }
  void move(double step) {
    gripper += step;
    out = out || pull() > holds;
  }
};

class Gauge final : public GaugeDevice {
 public:
  /// From its request number `slow_from` on it answers 5 ms later than it promises.
  Gauge(const Plug& plug, int slow_from) : plug_(plug), slow_from_(slow_from) {}

 private:
  void on_request_reading() override {
    const Time late = ++asked_ < slow_from_ ? Time::zero() : std::chrono::milliseconds(5);
    after(answers_after.worst + late, [this] { send_reading({std::llround(plug_.pull() * 40)}); });
  }
  const Plug& plug_;
  int slow_from_;
  int asked_ = 0;
};

class Axis final : public AxisDevice {
 public:
  explicit Axis(Plug& plug) : plug_(plug) {}
  void open() override { beat(); }

 private:
  void on_step(const Step& step) override { plug_.move(step.dz); }
  void beat() {
    after(period, [this] {
      send_beat();
      beat();
    });
  }
  Plug& plug_;
};

constexpr int never = 1'000'000;

/// Prints how the test of `plug` ended; true if with `expected`.
bool test(const char* what, Plug plug, int expected, int slow_from = never) {
  const auto skill = pull_test_skill();
  Gauge gauge(plug, slow_from);
  Axis axis(plug);
  StillWorld world;
  Device* devices[] = {&gauge, &axis};
  RunOptions options;
  options.on_broken_promise = OnBrokenPromise::contingency;
  const Outcome outcome = Dispatcher(devices, world).run(*skill, {}, options);
  std::cout << what << ": completion " << outcome.code << ", " << outcome.reason << " (gripper at "
            << plug.gripper << " mm)\n";
  for (const BrokenPromise& broken : outcome.broken_promises) std::cout << "  " << in_words(broken) << '\n';
  return outcome.code == expected;
}

}  // namespace

int main() {
  const bool seated = test("a plug that holds", {15, 100}, 0);
  const bool loose = test("a plug that slips", {15, 10}, 1);
  const bool slow = test("a gauge that gets slow", {15, 100}, 1, 10);
  return seated && loose && slow ? 0 : 1;
}
