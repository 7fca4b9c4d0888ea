// Tests two plugs on a bench that is a few lines long: one is seated, one is loose.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "activities.hpp"
#include "pal/runtime/dispatcher.hpp"
#include "pal/runtime/still_world.hpp"

using namespace std::chrono_literals;
using namespace pal::runtime;

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

class Gauge final : public Device {
 public:
  explicit Gauge(const Plug& plug) : plug_(plug) {}
  const std::string& name() const override { return name_; }
  const std::vector<PortSpec>& ports() const override { return ports_; }
  void attach(DeviceHost& host) override { host_ = &host; }
  void open() override {}
  void receive(std::size_t, std::span<const double>) override {
    host_->at(host_->now() + 1500us, [this] {
      const double counts[] = {std::round(plug_.pull() * 40)};
      host_->deliver(1, counts);
    });
  }
  void close() override {}

 private:
  const Plug& plug_;
  std::string name_ = "gauge";
  std::vector<PortSpec> ports_{{"request reading", true, {}}, {"reading", false, {{"value", ""}}}};
  DeviceHost* host_ = nullptr;
};

class Axis final : public Device {
 public:
  explicit Axis(Plug& plug) : plug_(plug) {}
  const std::string& name() const override { return name_; }
  const std::vector<PortSpec>& ports() const override { return ports_; }
  void attach(DeviceHost& host) override { host_ = &host; }
  void open() override { beat(); }
  void receive(std::size_t, std::span<const double> fields) override { plug_.move(fields[0]); }
  void close() override {}

 private:
  void beat() {
    host_->at(host_->now() + 10ms, [this] {
      host_->deliver(0, {});
      beat();
    });
  }
  Plug& plug_;
  std::string name_ = "axis";
  std::vector<PortSpec> ports_{{"beat", false, {}}, {"step", true, {{"dz", "mm"}}}};
  DeviceHost* host_ = nullptr;
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
