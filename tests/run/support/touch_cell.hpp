// A cell for the touch skill without physics. The tool goes where it is told, and the wall is a spring. A
// sensor and an ALTER port have the timing of workcell.pal.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "pal/runtime/device.hpp"

namespace pal::test {

using namespace std::chrono_literals;

/// Lengths in mm along the tool's Z axis. Each correction is gone evenly during the 28 ms after it was given.
class Tool {
 public:
  double wall = 1e9;
  double stiffness = 10;  // N/mm
  double furthest = 0;

  double position(runtime::Time now) const {
    const double part = std::chrono::duration<double>(now - since_).count() / 0.028;
    return from_ + (to_ - from_) * std::clamp(part, 0.0, 1.0);
  }
  double fz(runtime::Time now) const { return -stiffness * std::max(0.0, position(now) - wall); }
  void move(runtime::Time now, double dz) {
    from_ = position(now);
    to_ += dz;
    furthest = std::max(furthest, to_);
    since_ = now;
  }
  double target() const { return to_; }

 private:
  double from_ = 0;
  double to_ = 0;
  runtime::Time since_{};
};

/// Answers a request `answer` after it was taken with the force of that instant.
class ForceSensor final : public runtime::Device {
 public:
  ForceSensor(const Tool& tool, runtime::Time answer) : tool_(tool), answer_(answer) {}

  const std::string& name() const override { return name_; }
  const std::vector<runtime::PortSpec>& ports() const override { return ports_; }
  void attach(runtime::DeviceHost& host) override { host_ = &host; }
  void open() override {}
  void receive(std::size_t, std::span<const double>) override {
    host_->mark_busy(true);
    host_->at(host_->now() + answer_, [this] {
      host_->mark_busy(false);
      const double fields[] = {0, 0, tool_.fz(host_->now()), 0, 0, 0};
      host_->deliver(1, fields);
    });
  }
  void close() override { closed = true; }

  bool closed = false;

 private:
  std::string name_ = "force-torque";
  std::vector<runtime::PortSpec> ports_{
      {"request wrench", true, {}},
      {"wrench",
       false,
       {{"fx", "N"}, {"fy", "N"}, {"fz", "N"}, {"tx", "N*m"}, {"ty", "N*m"}, {"tz", "N*m"}}}};
  runtime::DeviceHost* host_ = nullptr;
  const Tool& tool_;
  runtime::Time answer_;
};

/// Asks every 28 ms; a fault if it is not answered within 20 ms.
class AlterPort final : public runtime::Device {
 public:
  AlterPort(Tool& tool, runtime::Time phase) : tool_(tool), phase_(phase) {}

  const std::string& name() const override { return name_; }
  const std::vector<runtime::PortSpec>& ports() const override { return ports_; }
  void attach(runtime::DeviceHost& host) override { host_ = &host; }
  void open() override {
    opened = host_->now();
    host_->at(opened + phase_, [this] { tick(); });
  }
  void receive(std::size_t, std::span<const double> fields) override {
    ++answered;
    waits_ = false;
    slowest = std::max(slowest, host_->now() - asked_);
    tool_.move(host_->now(), fields[2]);
  }
  void close() override { closed = true; }

  runtime::Time opened{-1};
  runtime::Time slowest{};
  int asked = 0;
  int answered = 0;
  bool closed = false;

 private:
  void tick() {
    ++asked;
    waits_ = true;
    asked_ = host_->now();
    host_->at(asked_ + 20ms, [this] {
      if (waits_) host_->fault("no answer within 20 ms");
    });
    host_->deliver(0, {});
    host_->at(asked_ + 28ms, [this] { tick(); });
  }

  std::string name_ = "alter";
  std::vector<runtime::PortSpec> ports_{
      {"tick", false, {}},
      {"correction",
       true,
       {{"dx", "mm"}, {"dy", "mm"}, {"dz", "mm"}, {"rx", "deg"}, {"ry", "deg"}, {"rz", "deg"}}}};
  runtime::DeviceHost* host_ = nullptr;
  Tool& tool_;
  runtime::Time phase_;
  runtime::Time asked_{};
  bool waits_ = false;
};

}  // namespace pal::test
