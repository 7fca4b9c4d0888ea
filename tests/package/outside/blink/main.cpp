// Runs the skill with a timer and a lamp; exit status 0 if the lamp was switched five times and is on.
#include "blink.hpp"

#include <iostream>

#include "pal/runtime/dispatcher.hpp"
#include "pal/runtime/still_world.hpp"

using namespace std::chrono_literals;
using namespace pal::runtime;

namespace {

class Timer final : public Device {
 public:
  const std::string& name() const override { return name_; }
  const std::vector<PortSpec>& ports() const override { return ports_; }
  void attach(DeviceHost& host) override { host_ = &host; }
  void open() override { tick(); }
  void receive(std::size_t, std::span<const double>) override {}
  void close() override {}

 private:
  void tick() {
    host_->at(host_->now() + 10ms, [this] {
      host_->deliver(0, {});
      tick();
    });
  }
  std::string name_ = "timer";
  std::vector<PortSpec> ports_{{"tick", false, {}}};
  DeviceHost* host_ = nullptr;
};

class Lamp final : public Device {
 public:
  const std::string& name() const override { return name_; }
  const std::vector<PortSpec>& ports() const override { return ports_; }
  void attach(DeviceHost&) override {}
  void open() override {}
  void receive(std::size_t, std::span<const double> fields) override {
    on = fields[0] != 0;
    ++switched;
  }
  void close() override {}
  bool on = false;
  int switched = 0;

 private:
  std::string name_ = "lamp";
  std::vector<PortSpec> ports_{{"light", true, {{"on", ""}}}};
};

}  // namespace

int main() {
  const auto skill = blink();
  Timer timer;
  Lamp lamp;
  StillWorld world;
  Device* devices[] = {&timer, &lamp};
  const ParameterValue times[] = {{"times", 5}};
  const Outcome outcome = Dispatcher(devices, world).run(*skill, times);
  std::cout << outcome.code << ' ' << outcome.reason << ' ' << lamp.switched << '\n';
  return outcome.code == 0 && lamp.switched == 5 && lamp.on ? 0 : 1;
}
