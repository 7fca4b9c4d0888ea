// A device that serves one request after the other, and shows in charts when it works: what generated classes
// of devices ON REQUEST derive from.
#pragma once

#include <cstddef>
#include <span>

#include "pal/runtime/port_device.hpp"

namespace pal::runtime {

/// A derived class says when a request has arrived, and answers by answer(). The device is then marked busy
/// from each request that it begins to serve until its answer; it needs no call of mark_busy.
class ServingDevice : public PortDevice {
 public:
  using PortDevice::PortDevice;

  void attach(DeviceHost& host) override {
    PortDevice::attach(host);
    serving_ = false;
    waiting_ = 0;
  }

 protected:
  /// A request has arrived. If the device is at work on another one, it waits.
  void asked() {
    if (serving_) {
      ++waiting_;
      return;
    }
    serving_ = true;
    host().mark_busy(true);
  }

  /// Delivers the answer to the oldest request, and begins with the next one. False: the answer is lost.
  bool answer(std::size_t port, std::span<const double> fields) {
    if (serving_) host().mark_busy(false);
    const bool taken = host().deliver(port, fields);
    next();
    return taken;
  }

  /// The oldest request, whose answer would be sent by the port, will have none; begins with the next one.
  void leave_unanswered(std::size_t port) {
    if (serving_) host().mark_busy(false);
    host().leave_unanswered(port);
    next();
  }

 private:
  void next() {
    serving_ = waiting_ > 0;
    if (!serving_) return;
    --waiting_;
    host().mark_busy(true);
  }

  bool serving_ = false;
  std::size_t waiting_ = 0;  // requests
};

}  // namespace pal::runtime
