// Observers of a run: of the messages between a skill and its devices, and of hand-written code.
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

  /// The device forgets a request that it was handed: no answer will come.
  virtual void forgotten([[maybe_unused]] const Device& device, [[maybe_unused]] std::size_t port) {}
};

class WorkObserver {
 public:
  virtual ~WorkObserver() = default;

  /// The hand-written code of statement `statement` of the wiring has held a processor of this computer for
  /// `time`: its processor time, or by the wall if it slept or waited. Called by the thread that ran it; in
  /// real time several threads call it. Must not throw, and changes nothing.
  virtual void worked(int statement, Time time) = 0;
};

}  // namespace pal::runtime
