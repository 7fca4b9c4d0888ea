// What the workcell's tests share: scenes of the project, and a host that keeps a device's appointments.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/workcell.hpp"

namespace pal::sim::test {

using namespace std::chrono_literals;

inline Scene scene(const std::string& name) {
  return find_scene(name, {PAL_SCENE_DIR});
}

/// Takes the place of the runtime: a queue of appointments, and a record of what the device did.
class Host final : public runtime::DeviceHost {
 public:
  struct Delivery {
    runtime::Time time;
    std::size_t port;
    std::vector<double> fields;
  };

  explicit Host(runtime::World& world) : world_(world) {}

  runtime::Time now() const override { return now_; }
  Appointment at(runtime::Time when, std::function<void()> action) override {
    queue_.emplace(when, std::move(action));
    return {};
  }
  void cancel(Appointment) override {}  // this host is never asked to
  bool deliver(std::size_t port, std::span<const double> fields) override {
    deliveries.push_back({now_, port, {fields.begin(), fields.end()}});
    if (on_delivery) on_delivery(deliveries.back());
    return true;
  }
  void mark_busy(bool busy) override { marks.emplace_back(now_, busy); }
  void fault(std::string reason) override { faults.push_back(std::move(reason)); }

  /// Keeps every appointment up to `end`.
  void run_until(runtime::Time end) {
    while (!queue_.empty() && queue_.begin()->first <= end) {
      const auto next = queue_.begin();
      now_ = next->first;
      world_.advance_to(now_);
      const std::function<void()> action = std::move(next->second);
      queue_.erase(next);
      action();
    }
    now_ = end;
    world_.advance_to(now_);
  }

  std::vector<Delivery> deliveries;
  std::vector<std::pair<runtime::Time, bool>> marks;
  std::vector<std::string> faults;
  std::function<void(const Delivery&)> on_delivery;

 private:
  runtime::World& world_;
  runtime::Time now_{};
  std::multimap<runtime::Time, std::function<void()>> queue_;
};

}  // namespace pal::sim::test
