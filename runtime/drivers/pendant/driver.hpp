// The driver of the pendant: what a person holds to move the arm.
#pragma once

#include <array>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "runtime/drivers/driver.hpp"

namespace pal::runtime::drivers {

/// One order of the person at the pendant: that the button is held, and what it asks for.
struct PendantOrder {
  /// How fast each axis is to go, of the speed that was set: from -1 to 1.
  std::array<double, 6> axes{};
  bool held = true;  // false: the button was released
};

/// Port `order` from the device: a to f, held. An order says that the person is there; the skill decides what
/// silence means.
///
/// Orders come from outside, by order(). The driver looks for a new one every 4 ms of station time. It hands on
/// the newest, and no two within 20 ms: the environment promises that distance. What came while no skill
/// waited for an order is forgotten, so that nothing moves by an old one.
class PendantDriver final : public Driver {
 public:
  PendantDriver();

  /// From any thread, at any time. It replaces an order that was not handed on yet.
  void order(const PendantOrder& order);

  const std::string& name() const override { return name_; }
  const std::vector<PortSpec>& ports() const override { return ports_; }
  void attach(DeviceHost& host) override;
  void open() override;
  void receive(std::size_t port, std::span<const double> fields) override;
  void close() override;

 private:
  void look();
  std::optional<PendantOrder> take();

  std::string name_ = "pendant";
  std::vector<PortSpec> ports_;
  DeviceHost* host_ = nullptr;
  DeviceHost::Appointment next_look_;
  Time earliest_{};  // of the next order
  std::mutex mutex_;
  std::optional<PendantOrder> newest_;  // under the mutex
};

}  // namespace pal::runtime::drivers
