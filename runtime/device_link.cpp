#include "runtime/device_link.hpp"

#include <stdexcept>
#include <utility>

#include "runtime/ports.hpp"
#include "runtime/run.hpp"

namespace pal::runtime {

DeviceLink::DeviceLink(Run& run, int index, Device& device, std::vector<int> channels)
    : run_(run), index_(index), device_(device), channels_(std::move(channels)) {}

Time DeviceLink::now() const {
  return run_.now();
}

DeviceHost::Appointment DeviceLink::at(Time when, std::function<void()> action) {
  if (when < run_.now()) {
    throw std::logic_error("asks to be called at " + std::to_string(when.count()) + " ns, which is over");
  }
  return run_.queue().push_action(when, static_cast<std::uint64_t>(index_), std::move(action));
}

void DeviceLink::cancel(Appointment appointment) {
  run_.queue().cancel(appointment);
}

bool DeviceLink::deliver(std::size_t port, std::span<const double> fields) {
  if (run_.over()) return true;
  const PortSpec& spec = device_.ports().at(port);
  if (spec.to_device || !is_payload(spec.fields, fields)) {
    throw std::logic_error("delivers " + spec.message + " in a form that its port does not have");
  }
  run_.observe(device_, port, fields);
  const int channel = channels_[port];
  if (channel < 0) return true;  // the skill has no use for this message
  return run_.mail().deliver(channel, fields);
}

void DeviceLink::mark_busy(bool busy) {
  if (run_.over()) return;
  if (busy != busy_) run_.record_device(busy ? trace::Kind::busy : trace::Kind::idle, index_);
  busy_ = busy;
  marks_itself_ = true;
  if (busy) run_.mail().device_takes_request(index_);
}

void DeviceLink::fault(std::string reason) {
  run_.fail_device(index_, device_.name() + ": " + reason);
}

void DeviceLink::open() {
  if (std::exchange(opened_, true)) return;
  device_.open();
}

}  // namespace pal::runtime
