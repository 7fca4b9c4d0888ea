// The common part of all drivers of devices at the far end of a link: the session, the time-out, the trouble.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/drivers/driver.hpp"
#include "runtime/drivers/link.hpp"
#include "runtime/drivers/timeline.hpp"

namespace pal::runtime::drivers {

/// A driver that awaits at most one thing at a time, for a limited time. Trouble outside a session waits for
/// trouble(); in a session it also ends the skill.
class LinkedDriver : public Driver, private LinkUser {
 public:
  LinkedDriver(const LinkedDriver&) = delete;
  LinkedDriver& operator=(const LinkedDriver&) = delete;
  ~LinkedDriver() override;

  const std::string& name() const override { return name_; }
  const std::vector<PortSpec>& ports() const override { return ports_; }
  void attach(DeviceHost& host) override { host_ = &host; }
  void close() override { host_ = nullptr; }
  std::string trouble() const override { return trouble_; }

 protected:
  /// The timeline and the link outlive the driver.
  LinkedDriver(Timeline& timeline, Link& link, std::string name, std::vector<PortSpec> ports);

  /// Bytes have arrived.
  virtual void arrived(Bytes bytes) = 0;
  /// Nothing is awaited any more: the request has failed, and so do those that wait.
  virtual void give_up() = 0;
  /// What is awaited and how much of it has come: "only 7 of the 13 bytes of a record came".
  virtual std::string missing() const = 0;
  /// The awaited bytes have not come in time. This is trouble, unless the driver overrides it.
  virtual void late();

  Timeline& timeline() { return timeline_; }
  /// The skill's session; null between skills.
  DeviceHost* host() const { return host_; }
  void write(Bytes bytes) { link_.write(bytes); }

  /// From now on something is awaited: it is late() if `time` passes before arrived_in_time().
  void await(Time time);
  void arrived_in_time() { timeline_.cancel(time_out_); }
  /// The first reason counts.
  void fail(std::string reason);
  /// Trouble is forgotten: the device is tried once more.
  void try_again() { trouble_.clear(); }

 private:
  void on_bytes(Bytes bytes) final {
    if (trouble_.empty()) arrived(bytes);
  }
  void on_break(std::string_view reason) final;

  Timeline& timeline_;
  Link& link_;
  std::string name_;
  std::vector<PortSpec> ports_;
  DeviceHost* host_ = nullptr;
  Timeline::Token time_out_;
  Time awaited_for_{};
  std::string trouble_;
};

/// "1.5 ms", "20 ms": for messages.
std::string in_milliseconds(Time time);
/// Bytes for messages: hexadecimal numbers with a space between.
std::string in_hexadecimal(Bytes bytes);
/// The same, but printable text stands as text in quotes.
std::string shown(Bytes bytes);

}  // namespace pal::runtime::drivers
