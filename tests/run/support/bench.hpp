// Runs a written skill on the bench: no physics, devices that do what the test says.
#pragma once

#include <deque>
#include <utility>
#include <vector>

#include "pal/runtime/dispatcher.hpp"
#include "tests/run/support/written_skill.hpp"

namespace pal::test {

/// A device of the test's making.
class ScriptedDevice : public runtime::Device {
 public:
  ScriptedDevice(std::string name, std::vector<runtime::PortSpec> ports)
      : name_(std::move(name)), ports_(std::move(ports)) {}

  const std::string& name() const override { return name_; }
  const std::vector<runtime::PortSpec>& ports() const override { return ports_; }
  void attach(runtime::DeviceHost& host) override { host_ = &host; }
  void open() override {
    ++opened;
    opened_at = host_->now();
    if (on_open) on_open(*host_);
  }
  void receive(std::size_t port, std::span<const double> fields) override {
    if (on_receive) on_receive(*host_, port, fields);
  }
  bool withdraw(std::size_t port) override { return on_withdraw && on_withdraw(port); }
  void close() override { ++closed; }

  std::function<void(runtime::DeviceHost&)> on_open;
  std::function<void(runtime::DeviceHost&, std::size_t, std::span<const double>)> on_receive;
  std::function<bool(std::size_t)> on_withdraw;
  int opened = 0;
  int closed = 0;
  runtime::Time opened_at{-1};

 private:
  std::string name_;
  std::vector<runtime::PortSpec> ports_;
  runtime::DeviceHost* host_ = nullptr;
};

inline runtime::Outcome run(WrittenSkill& skill, std::vector<runtime::Device*> devices = {},
                            const runtime::RunOptions& options = {}) {
  NoWorld world;
  runtime::Dispatcher dispatcher(devices, world);
  return dispatcher.run(skill, {}, options);
}

}  // namespace pal::test
