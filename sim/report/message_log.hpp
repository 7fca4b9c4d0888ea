// The messages through the ports of the devices: commands to them, readings from them.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pal/runtime/observer.hpp"
#include "pal/trace/spool.hpp"

namespace pal::sim {

/// A message that a device was given or has given.
struct LoggedMessage {
  runtime::Time time{};
  std::size_t device = 0, port = 0;  // into MessageLog::devices(), and its ports
  std::vector<double> fields;
};

/// Records the messages of a run, on the disk as they come, or in memory. Give it to the run as its observer.
class MessageLog final : public runtime::MessageObserver {
 public:
  /// Throws std::runtime_error if there can be no temporary file.
  explicit MessageLog(trace::SpoolPlace place = trace::SpoolPlace::disk);
  void passed(runtime::Time when, const runtime::Device& device, std::size_t port,
              std::span<const double> fields) override;

  struct DeviceNames {
    std::string name;
    std::vector<runtime::PortSpec> ports;
  };
  /// Those that messages with fields went to or came from, in the order in which they were first seen.
  const std::vector<DeviceNames>& devices() const { return devices_; }
  std::size_t size() const { return size_; }
  /// Some were lost, because the disk was full.
  bool failed() const { return file_->failed(); }
  /// All messages, in the order in which they passed.
  void for_each(const std::function<void(const LoggedMessage&)>& see) const;

  /// Reads the messages one by one, in the order in which they passed. The log outlives it.
  class Reader {
   public:
    explicit Reader(const MessageLog& log) : log_(log) {}
    /// The next message; nullptr behind the last one. It is valid until the next call.
    const LoggedMessage* next();

   private:
    bool take(void* to, std::size_t count);

    const MessageLog& log_;
    std::vector<std::byte> room_;
    std::size_t taken_ = 0;   // of `room_`
    std::size_t offset_ = 0;  // in the file, behind `room_`
    LoggedMessage message_;
  };

 private:
  std::size_t number_of(const runtime::Device& device);

  std::vector<DeviceNames> devices_;
  std::shared_ptr<trace::SpoolFile> file_;
  std::vector<std::byte> record_;  // the one that is written
  std::size_t size_ = 0;
};

}  // namespace pal::sim
