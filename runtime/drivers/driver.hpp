// A device at the far end of a link: a PAL device binds to it when it exchanges bytes.
#pragma once

#include "pal/runtime/device.hpp"

namespace pal::runtime::drivers {

/// A driver belongs to a station and outlives the skills that use it. Each skill is a session: attach(),
/// open(), messages, close(). Between sessions a driver goes on serving its device (an ALTER port is answered
/// with no motion). Its clock is the station's Timeline, which goes on between sessions. `DeviceHost` exists
/// only during a session.
class Driver : public Device {
 public:
  /// The station's first skill, whichever devices it uses, is about to begin: the arm has not moved yet. True
  /// if the device can do something only now; time then goes on until ready(). A device in trouble is in the
  /// way of those skills alone that use it.
  virtual bool commission() { return false; }
  /// A skill that uses this device is about to begin. Brings the device to where a session may start, for
  /// example by a dialogue that opens it. Time goes on until ready(). trouble() says what went wrong.
  virtual void prepare() {}
  virtual bool ready() const { return true; }
  /// A skill that does not use this device is about to begin. Gives up what would be in its way. Time goes on
  /// until released().
  virtual void release() {}
  virtual bool released() const { return true; }
  /// Why the device cannot be used at present; empty: it can.
  virtual std::string trouble() const { return {}; }
};

}  // namespace pal::runtime::drivers
