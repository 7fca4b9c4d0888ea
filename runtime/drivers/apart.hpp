// Devices that live in another thread than the run that uses them. This is the edge between the kernel of a
// run in real time and the thread that moves the world.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "pal/runtime/device.hpp"
#include "runtime/drivers/timeline.hpp"

namespace pal::runtime::drivers {

class DeviceApart;

/// What the run has for devices, in its order: a queue from all threads of the run to the world's.
class Letters {
 public:
  struct Letter {
    enum class Kind { open, message, action, withdrawn };
    Kind kind = Kind::open;
    Time when{};  // of the run
    DeviceApart* device = nullptr;
    std::size_t port = 0;
    std::uint64_t request = 0;
    std::vector<double> fields;
    std::function<void()> action;
  };

  /// `wake` is called after each letter, from the thread that has sent it.
  explicit Letters(std::function<void()> wake) : wake_(std::move(wake)), ring_(64) {}

  void open(DeviceApart& device, Time when);
  void message(DeviceApart& device, Time when, std::size_t port, std::uint64_t request,
               std::span<const double> fields);
  void action(DeviceApart& device, std::function<void()> action);
  /// Takes back the last message for the port. False: it is read already.
  bool withdraw(const DeviceApart& device, std::size_t port);

  /// Takes the oldest letter, if it is not younger than `when`. The contents of `letter` are used again.
  bool read(Time when, Letter& letter);
  bool empty() const;

 private:
  Letter& next();
  void send(std::unique_lock<std::mutex> lock);

  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::vector<Letter> ring_;  // grows if it is full
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

/// A device as the run sees it, and the run as the device sees it. The device is called by the world's thread
/// alone, except for attach(), before the run begins, and for close(), after its end. What it delivers enters
/// the kernel at once, for as long as that takes and no longer.
class DeviceApart final : public Device, private DeviceHost {
 public:
  /// All outlive this. `begun`: the instant of the timeline at which the run begins.
  DeviceApart(Device& device, Timeline& timeline, Time begun, Letters& letters)
      : device_(device), timeline_(timeline), begun_(begun), letters_(letters) {}
  ~DeviceApart() override { *alive_ = false; }

  // For the run.
  const std::string& name() const override { return device_.name(); }
  const std::vector<PortSpec>& ports() const override { return device_.ports(); }
  void attach(DeviceHost& host) override;
  void open() override { letters_.open(*this, run_->now()); }
  void receive(std::size_t port, std::span<const double> fields) override {
    letters_.message(*this, run_->now(), port, run_->request(), fields);
  }
  bool withdraw(std::size_t port) override { return letters_.withdraw(*this, port); }
  void close() override { device_.close(); }

  // For the world's thread.
  void take(const Letters::Letter& letter);

 private:
  // For the device.
  Time now() const override { return std::max(Time::zero(), timeline_.now() - begun_); }
  Appointment at(Time when, std::function<void()> action) override;
  void cancel(Appointment appointment) override;
  bool deliver(std::size_t port, std::span<const double> fields) override;
  Request request() const override { return request_; }
  bool answer(Request request, std::size_t port, std::span<const double> fields) override;
  void leave_unanswered(std::size_t port) override;
  void mark_busy(bool busy) override;
  void fault(std::string reason) override;
  void post(std::function<void()> action) override;

  void call(const std::function<void()>& function);
  void act(const std::function<void()>& action);

  Device& device_;
  Timeline& timeline_;
  Time begun_;
  Letters& letters_;
  DeviceHost* run_ = nullptr;
  bool attaching_ = false;
  Request request_ = 0;  // with which receive() is being called
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace pal::runtime::drivers
