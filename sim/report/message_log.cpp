#include "sim/report/message_log.hpp"

namespace pal::sim {

// A device to the skill, and the skill's host to the device.
class MessageLog::Watched final : public runtime::Device, public runtime::DeviceHost {
 public:
  Watched(runtime::Device& device, std::size_t number, std::vector<LoggedMessage>& messages)
      : device_(device), number_(number), messages_(messages) {}

  const std::string& name() const override { return device_.name(); }
  const std::vector<runtime::PortSpec>& ports() const override { return device_.ports(); }
  void attach(runtime::DeviceHost& host) override {
    host_ = &host;
    device_.attach(*this);
  }
  void open() override { device_.open(); }
  void receive(std::size_t port, std::span<const double> fields) override {
    write_down(port, fields);
    device_.receive(port, fields);
  }
  bool withdraw(std::size_t port) override { return device_.withdraw(port); }
  void close() override { device_.close(); }

  runtime::Time now() const override { return host_->now(); }
  void at(runtime::Time when, std::function<void()> action) override { host_->at(when, std::move(action)); }
  bool deliver(std::size_t port, std::span<const double> fields) override {
    write_down(port, fields);
    return host_->deliver(port, fields);
  }
  void mark_busy(bool busy) override { host_->mark_busy(busy); }
  void fault(std::string reason) override { host_->fault(std::move(reason)); }

 private:
  void write_down(std::size_t port, std::span<const double> fields) {
    // A message without fields says nothing that the trace does not say.
    if (!fields.empty()) messages_.push_back({host_->now(), number_, port, {fields.begin(), fields.end()}});
  }

  runtime::Device& device_;
  std::size_t number_;
  std::vector<LoggedMessage>& messages_;
  runtime::DeviceHost* host_ = nullptr;
};

MessageLog::MessageLog() = default;
MessageLog::~MessageLog() = default;

runtime::Device& MessageLog::watch(runtime::Device& device) {
  watched_.push_back(std::make_unique<Watched>(device, devices_.size(), messages_));
  devices_.push_back({device.name(), device.ports()});
  return *watched_.back();
}

}  // namespace pal::sim
