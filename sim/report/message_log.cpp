#include "sim/report/message_log.hpp"

#include <algorithm>

namespace pal::sim {

void MessageLog::passed(runtime::Time when, const runtime::Device& device, std::size_t port,
                        std::span<const double> fields) {
  // A message without fields says nothing that the trace does not say.
  if (!fields.empty()) messages_.push_back({when, number_of(device), port, {fields.begin(), fields.end()}});
}

std::size_t MessageLog::number_of(const runtime::Device& device) {
  const auto found = std::find_if(devices_.begin(), devices_.end(),
                                  [&](const DeviceNames& known) { return known.name == device.name(); });
  if (found == devices_.end()) {
    devices_.push_back({device.name(), device.ports()});
    return devices_.size() - 1;
  }
  return static_cast<std::size_t>(found - devices_.begin());
}

}  // namespace pal::sim
