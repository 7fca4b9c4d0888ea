// Who looks on at the messages between a skill and its devices.
#pragma once

#include <span>

#include "pal/runtime/device.hpp"

namespace pal::runtime {

class MessageObserver {
 public:
  virtual ~MessageObserver() = default;

  /// A message was handed to the device, or the device has delivered it (as its port says), at instant `when`
  /// of the run. Must not throw, and changes nothing.
  virtual void passed(Time when, const Device& device, std::size_t port, std::span<const double> fields) = 0;
};

}  // namespace pal::runtime
