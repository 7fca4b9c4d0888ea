// One device in one run.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "pal/runtime/device.hpp"
#include "pal/runtime/executive.hpp"
#include "pal/runtime/observer.hpp"
#include "runtime/kernel/journal.hpp"
#include "runtime/kernel/mail.hpp"

namespace pal::runtime {

/// Does for the run what an attached device asks for.
class DeviceLink final : public DeviceHost {
 public:
  /// `channels`: for each port of the device the channel that it is one end of, or -1.
  DeviceLink(Executive& executive, Journal& journal, Mail& mail, MessageObserver* observer, int index,
             std::string name, Device& device, std::vector<int> channels);

  Time now() const override;
  Appointment at(Time when, std::function<void()> action) override;
  void cancel(Appointment appointment) override;
  bool deliver(std::size_t port, std::span<const double> fields) override { return answer(0, port, fields); }
  Request request() const override { return request_; }
  bool answer(Request request, std::size_t port, std::span<const double> fields) override;
  void leave_unanswered(std::size_t port) override;
  void mark_busy(bool busy) override;
  void fault(std::string reason) override;
  void post(std::function<void()> action) override { executive_.post(index_, std::move(action)); }

  Device& device() const { return device_; }
  /// The device receives a message; `request`: its number, if it is one.
  void receive(std::size_t port, std::span<const double> fields, Request request);
  void open();
  /// A message passes the port.
  void observe(std::size_t port, std::span<const double> fields) const;
  /// The device forgets the request that it was handed at the port.
  void observe_forgotten(std::size_t port) const;
  /// Whether the device says when it takes its requests.
  bool busy() const { return busy_; }
  bool marks_itself() const { return marks_itself_; }

 private:
  Executive& executive_;
  Journal& journal_;
  Mail& mail_;
  MessageObserver* observer_;
  int index_;
  std::string name_;
  Device& device_;
  std::vector<int> channels_;
  bool opened_ = false;
  bool busy_ = false;
  bool marks_itself_ = false;
  Request request_ = 0;
};

}  // namespace pal::runtime
