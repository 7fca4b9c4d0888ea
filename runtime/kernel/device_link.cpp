#include "runtime/kernel/device_link.hpp"

#include <stdexcept>
#include <utility>

#include "runtime/kernel/ports.hpp"

namespace pal::runtime {

DeviceLink::DeviceLink(Executive& executive, Journal& journal, Mail& mail, MessageObserver* observer,
                       int index, std::string name, Device& device, std::vector<int> channels)
    : executive_(executive),
      journal_(journal),
      mail_(mail),
      observer_(observer),
      index_(index),
      name_(std::move(name)),
      device_(device),
      channels_(std::move(channels)) {}

Time DeviceLink::now() const {
  return executive_.now();
}

DeviceHost::Appointment DeviceLink::at(Time when, std::function<void()> action) {
  if (when < executive_.now()) {
    throw std::logic_error("asks to be called at " + std::to_string(when.count()) + " ns, which is over");
  }
  return {0, executive_.at(when, index_, std::move(action)).number};
}

void DeviceLink::cancel(Appointment appointment) {
  executive_.cancel({appointment.order});
}

void DeviceLink::receive(std::size_t port, std::span<const double> fields, Request request) {
  observe(port, fields);
  request_ = request;
  device_.receive(port, fields);
  request_ = 0;
}

bool DeviceLink::answer(Request request, std::size_t port, std::span<const double> fields) {
  if (journal_.over()) return true;
  const PortSpec& spec = device_.ports().at(port);
  if (spec.to_device || !is_payload(spec.fields, fields)) {
    throw std::logic_error("delivers " + spec.message + " in a form that its port does not have");
  }
  observe(port, fields);
  const int channel = channels_[port];
  if (channel < 0) return true;  // the skill has no use for this message
  return mail_.deliver(channel, fields, request);
}

void DeviceLink::leave_unanswered(std::size_t port) {
  if (journal_.over()) return;
  if (device_.ports().at(port).to_device) throw std::logic_error("leaves a message unanswered that it takes");
  if (channels_[port] >= 0) mail_.left_unanswered(channels_[port]);
}

void DeviceLink::mark_busy(bool busy) {
  if (journal_.over()) return;
  if (busy != busy_) journal_.record_device(busy ? trace::Kind::busy : trace::Kind::idle, index_);
  busy_ = busy;
  marks_itself_ = true;
  if (busy) mail_.device_takes_request(index_);
}

void DeviceLink::fault(std::string reason) {
  journal_.fail_device(index_, name_ + ": " + reason);
}

void DeviceLink::open() {
  if (std::exchange(opened_, true)) return;
  device_.open();
}

void DeviceLink::observe(std::size_t port, std::span<const double> fields) const {
  if (observer_ != nullptr) observer_->passed(executive_.now(), device_, port, fields);
}

void DeviceLink::observe_forgotten(std::size_t port) const {
  if (observer_ != nullptr) observer_->forgotten(device_, port);
}

}  // namespace pal::runtime
