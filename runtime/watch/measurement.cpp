#include "pal/runtime/measurement.hpp"

#include <algorithm>

namespace pal::runtime {

void Extremes::add(Time time) {
  const Time::rep value = time.count();
  Time::rep least = least_.load(std::memory_order_relaxed);
  while (value < least && !least_.compare_exchange_weak(least, value, std::memory_order_relaxed)) {
  }
  Time::rep greatest = greatest_.load(std::memory_order_relaxed);
  while (value > greatest && !greatest_.compare_exchange_weak(greatest, value, std::memory_order_relaxed)) {
  }
  count_.fetch_add(1, std::memory_order_relaxed);
}

Measurement::Measurement(const Wiring& wiring) : wiring_(wiring), statements_(wiring.statements.size()) {}

void Measurement::begin_run() {
  ++runs_;
  for (KnownDevice& device : devices_) {
    device.device = nullptr;  // another run may have others of the same names
    device.last_answer = Time(-1);
    for (Port& port : device.ports) {
      port.open.clear();
      port.seen = false;
    }
  }
}

/// Its ports are matched with the channels when it is first seen in a run.
Measurement::KnownDevice& Measurement::known(const Device& device) {
  for (KnownDevice& each : devices_) {
    if (each.device == &device && each.name == device.name()) return each;
  }
  for (KnownDevice& each : devices_) {
    if (each.name != device.name()) continue;
    each.device = &device;
    return each;
  }
  KnownDevice& found = devices_.emplace_back();
  found.device = &device;
  found.name = device.name();
  const std::vector<PortSpec>& ports = device.ports();
  const auto port_of = [&](std::string_view message, bool to_device) {
    const auto at = std::find_if(ports.begin(), ports.end(), [&](const PortSpec& port) {
      return port.message == message && port.to_device == to_device;
    });
    return static_cast<std::size_t>(at - ports.begin());
  };
  found.ports.resize(ports.size());
  for (std::size_t p = 0; p < ports.size(); ++p) found.ports[p].message = ports[p].message;
  for (const ChannelSpec& channel : wiring_.channels) {
    if (channel.from_device && channel.sender == found.name) {
      const std::size_t port = port_of(channel.message, false);
      if (port < ports.size() && found.ports[port].kind == Port::Kind::other)
        found.ports[port].kind = Port::Kind::event;
    }
    if (!channel.to_device || channel.receiver != found.name || !channel.request || channel.answer < 0)
      continue;
    const std::size_t request = port_of(channel.message, true);
    const std::size_t answer =
        port_of(wiring_.channels[static_cast<std::size_t>(channel.answer)].message, false);
    if (request == ports.size() || answer == ports.size()) continue;
    found.ports[request].kind = Port::Kind::request;
    found.ports[request].answered_by = answer;
    found.ports[answer].kind = Port::Kind::answer;
    found.ports[answer].open.reserve(wiring_.threads.size() + 1);
  }
  return found;
}

void Measurement::passed(Time when, const Device& device, std::size_t number, std::span<const double>) {
  KnownDevice& of = known(device);
  Port& port = of.ports[number];
  switch (port.kind) {
    case Port::Kind::other:
      break;
    case Port::Kind::request:
      of.ports[port.answered_by].open.push_back(when);
      break;
    case Port::Kind::answer:
      if (port.open.empty()) break;  // what the device sends unasked is none of its answers
      if (of.last_answer != when) of.answers.add(when - std::max(port.open.front(), of.last_answer));
      of.last_answer = when;
      port.open.erase(port.open.begin());
      break;
    case Port::Kind::event:
      if (port.seen) port.apart.add(when - port.last);
      port.seen = true;
      port.last = when;
      break;
  }
}

void Measurement::forgotten(const Device& device, std::size_t number) {
  KnownDevice& of = known(device);
  const Port& port = of.ports[number];
  if (port.kind != Port::Kind::request) return;
  std::vector<Time>& open = of.ports[port.answered_by].open;
  if (!open.empty()) open.pop_back();
}

void Measurement::worked(int statement, Time time) {
  statements_[static_cast<std::size_t>(statement)].add(time);
}

}  // namespace pal::runtime
