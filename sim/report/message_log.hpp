// What went through the ports of the devices: commands to them, readings from them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/device.hpp"

namespace pal::sim {

/// A message that a device was given or has given.
struct LoggedMessage {
  runtime::Time time{};
  std::size_t device = 0, port = 0;  // into MessageLog::devices(), and its ports
  std::vector<double> fields;
};

/// Stands between skill and devices and writes down what passes.
class MessageLog {
 public:
  MessageLog();
  ~MessageLog();
  MessageLog(const MessageLog&) = delete;
  MessageLog& operator=(const MessageLog&) = delete;

  /// The device to give to the dispatcher in place of `device`; both must outlive the run.
  runtime::Device& watch(runtime::Device& device);

  struct DeviceNames {
    std::string name;
    std::vector<runtime::PortSpec> ports;
  };
  const std::vector<DeviceNames>& devices() const { return devices_; }
  /// In the order in which they passed.
  const std::vector<LoggedMessage>& messages() const { return messages_; }

 private:
  class Watched;
  std::vector<DeviceNames> devices_;
  std::vector<std::unique_ptr<Watched>> watched_;
  std::vector<LoggedMessage> messages_;
};

}  // namespace pal::sim
