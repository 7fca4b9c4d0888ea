// A device with a name, ports and a host: what generated classes of devices derive from.
#pragma once

#include <cassert>
#include <functional>
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

 private:
  std::string name_;
  std::vector<PortSpec> ports_;
  DeviceHost* host_ = nullptr;
};

}  // namespace pal::runtime
