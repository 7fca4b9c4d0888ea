// Takes the place of a running skill: a session of a driver by the station's clock, with a record of what it
// did.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/drivers/driver.hpp"
#include "runtime/drivers/timeline.hpp"

namespace pal::runtime::drivers::test {

class Session final : public DeviceHost {
 public:
  struct Delivery {
    Time time;
    std::size_t port;
    std::vector<double> fields;
  };

  Session(Timeline& timeline, Driver& driver) : timeline_(timeline), driver_(driver) {}

  /// The device is brought to where a session may start, and the session begins.
  void begin() {
    driver_.prepare();
    while (!driver_.ready() && timeline_.next() != Timeline::never) timeline_.advance_to(timeline_.next());
    if (!driver_.trouble().empty()) return;
    driver_.attach(*this);
    driver_.open();
  }

  Time now() const override { return timeline_.now(); }
  Appointment at(Time when, std::function<void()> action) override {
    const Timeline::Token token = timeline_.at(when, std::move(action));
    return {token.slot, token.generation};
  }
  void cancel(Appointment appointment) override {
    timeline_.cancel({appointment.slot, static_cast<std::uint32_t>(appointment.order)});
  }
  bool deliver(std::size_t port, std::span<const double> fields) override {
    deliveries.push_back({now(), port, {fields.begin(), fields.end()}});
    return true;
  }
  void mark_busy(bool busy) override { marks.emplace_back(now(), busy); }
  void fault(std::string reason) override { faults.push_back(std::move(reason)); }

  std::vector<Delivery> deliveries;
  std::vector<std::pair<Time, bool>> marks;
  std::vector<std::string> faults;

 private:
  Timeline& timeline_;
  Driver& driver_;
};

}  // namespace pal::runtime::drivers::test
