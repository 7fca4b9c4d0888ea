// Tests two plugs on a bench that is a few lines long: one is seated, one is loose.
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
  explicit Gauge(const Plug& plug) : plug_(plug) {}

 private:
  void on_request_reading() override {
    after(answers_after.worst, [this] { send_reading({std::llround(plug_.pull() * 40)}); });
  }
  const Plug& plug_;
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

/// Prints how the test of `plug` ended; true if with `expected`.
bool test(const char* what, Plug plug, int expected) {
  const auto skill = pull_test_skill();
  Gauge gauge(plug);
  Axis axis(plug);
  StillWorld world;
  Device* devices[] = {&gauge, &axis};
  const Outcome outcome = Dispatcher(devices, world).run(*skill);
  std::cout << what << ": completion " << outcome.code << ", " << outcome.reason << " (gripper at "
            << plug.gripper << " mm)\n";
  return outcome.code == expected;
}

}  // namespace

int main() {
  const bool seated = test("a plug that holds", {15, 100}, 0);
  const bool loose = test("a plug that slips", {15, 10}, 1);
  return seated && loose ? 0 : 1;
}
