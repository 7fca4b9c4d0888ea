// A device that is at the far end of a link: what a PAL device binds to when it speaks bytes.
#pragma once

#include "runtime/device.hpp"

namespace pal::runtime {

/// A driver belongs to a station and outlives the skills that use it. A skill is a session of it: attach(),
/// open(), messages, close(). Between sessions a driver keeps its device content (an ALTER port is answered
/// with no motion). It keeps time by the station's Timeline, which goes on between sessions; `DeviceHost` is
/// there during one.
class Driver : public Device {
 public:
  /// A skill that uses this device is about to begin: brings the device to where a session may start (a
  /// dialogue that opens it). Time goes on until ready(). What goes wrong is said by trouble().
  virtual void prepare() {}
  virtual bool ready() const { return true; }
  /// A skill that does not use this device is about to begin: gives up what would be in its way. Time goes on
  /// until released().
  virtual void release() {}
  virtual bool released() const { return true; }
  /// Why the device cannot be used at present; empty: it can.
  virtual std::string trouble() const { return {}; }
};

}  // namespace pal::runtime
