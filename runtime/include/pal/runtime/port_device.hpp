// A device with a name, ports and a host: what generated classes of devices derive from.
#pragma once

#include <algorithm>
#include <cassert>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "pal/runtime/device.hpp"

namespace pal::runtime {

/// A derived device only has to say what it does with messages. open() and close() do nothing unless
/// overridden.
class PortDevice : public Device {
 public:
  PortDevice(std::string name, std::vector<PortSpec> ports)
      : name_(std::move(name)), ports_(std::move(ports)) {}

  const std::string& name() const final { return name_; }
  const std::vector<PortSpec>& ports() const final { return ports_; }
  /// An override calls this one first.
  void attach(DeviceHost& host) override { host_ = &host; }
  void open() override {}
  void close() override {}

 protected:
  /// Of the run that the device is attached to.
  DeviceHost& host() const {
    assert(host_ != nullptr);
    return *host_;
  }
  Time now() const { return host().now(); }
  /// Calls `action` after `delay` (not negative), unless the skill ends before or the call is cancelled.
  DeviceHost::Appointment after(Time delay, std::function<void()> action) {
    return host().at(now() + delay, std::move(action));
  }
  /// Calls `action` after `phase`, and every `period` (more than nothing) after that, until the skill ends.
  /// Errors do not add up: each call is asked for at its own multiple of the period. One that is late in real
  /// time comes as soon as it can.
  void every(Time period, Time phase, std::function<void()> action) {
    assert(period > Time::zero());
    call_at(now() + phase, period, std::make_shared<std::function<void()>>(std::move(action)));
  }

 private:
  void call_at(Time due, Time period, const std::shared_ptr<std::function<void()>>& action) {
    host().at(std::max(due, now()), [this, due, period, action] {
      call_at(due + period, period, action);
      (*action)();
    });
  }

  std::string name_;
  std::vector<PortSpec> ports_;
  DeviceHost* host_ = nullptr;
};

}  // namespace pal::runtime
