// The world outside this process: its clock, and links to it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "runtime/drivers/link.hpp"
#include "runtime/drivers/station.hpp"
#include "runtime/drivers/timeline.hpp"

namespace pal::runtime::drivers {

/// A link that leaves the process. Bytes that come in are stamped with the station time at which they came,
/// and the timeline hands them to the user at that instant. If the far end does not read and the system's
/// buffer is full, bytes are lost, as on a serial line.
class OutsideLink : public Link {
 public:
  /// Where a program finds the far end: "/dev/pts/3", "127.0.0.1:7000".
  virtual const std::string& address() const = 0;
};

/// Virtual time in step with the wall clock: at a factor of 2 two seconds of station time pass in one. If the
/// process falls behind, station time catches up as fast as it can, and nothing is left out. For one thread
/// only, but for wake().
class Outside final : public Pace {
 public:
  /// Contract: factor > 0.
  explicit Outside(double factor = 1);
  ~Outside() override;
  Outside(const Outside&) = delete;
  Outside& operator=(const Outside&) = delete;

  /// Returns after 50 ms of real time at the latest, so that a waiting caller can be stopped.
  Time wait_until(Time when) override;
  void resumed(Time now) override;
  void wake() override;

  // Links; they use the timeline and this until they are destroyed. Each throws std::runtime_error with the
  // system's reason when it cannot be opened.
  /// A pseudo-terminal. Programs may come and go at its far end.
  std::unique_ptr<OutsideLink> open_pseudo_terminal(Timeline& timeline);
  /// Listens on this machine; port 0: any that is free. One program at a time; its going is a break.
  std::unique_ptr<OutsideLink> listen_tcp(Timeline& timeline, std::uint16_t port);
  /// Connects to a device on the network, or to one that listen_tcp serves.
  std::unique_ptr<OutsideLink> connect_tcp(Timeline& timeline, const std::string& host, std::uint16_t port);
  /// A serial port: 8 bits, no parity, 1 stop bit, no flow control.
  std::unique_ptr<OutsideLink> open_serial(Timeline& timeline, const std::string& path, unsigned baud);

  struct Parts;

 private:
  std::unique_ptr<Parts> parts_;
};

}  // namespace pal::runtime::drivers
