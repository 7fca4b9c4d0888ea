// The messages through the ports of the devices: commands to them, readings from them.
#pragma once

#include <string>
#include <vector>

#include "pal/runtime/observer.hpp"

namespace pal::sim {

/// A message that a device was given or has given.
struct LoggedMessage {
  runtime::Time time{};
  std::size_t device = 0, port = 0;  // into MessageLog::devices(), and its ports
  std::vector<double> fields;
};

/// Records the messages of a run. Give it to the run as its observer.
class MessageLog final : public runtime::MessageObserver {
 public:
  void passed(runtime::Time when, const runtime::Device& device, std::size_t port,
              std::span<const double> fields) override;

  struct DeviceNames {
    std::string name;
    std::vector<runtime::PortSpec> ports;
  };
  /// Those that messages with fields went to or came from, in the order in which they were first seen.
  const std::vector<DeviceNames>& devices() const { return devices_; }
  /// In the order in which they passed.
  const std::vector<LoggedMessage>& messages() const { return messages_; }

 private:
  std::size_t number_of(const runtime::Device& device);

  std::vector<DeviceNames> devices_;
  std::vector<LoggedMessage> messages_;
};

}  // namespace pal::sim
