// Runs skills one after the other, with devices and physics that go on between them.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pal/runtime/dispatcher.hpp"
#include "runtime/drivers/driver.hpp"
#include "runtime/drivers/timeline.hpp"

namespace pal::runtime::drivers {

/// How station time goes by; without one it is virtual and waits for nothing.
class Pace {
 public:
  virtual ~Pace() = default;
  /// Returns `when` once the outside world has come to `when` (station time). If something came in from
  /// outside earlier, returns that instant; an action of the station's timeline is then due by that instant.
  virtual Time wait_until(Time when) = 0;
  /// Station time stood still at `now` and goes on from here.
  virtual void resumed([[maybe_unused]] Time now) {}
  /// From any thread: wait_until() returns soon.
  virtual void wake() {}
};

struct StationOptions {
  /// Devices must be ready for a skill, or given up before one, within this time.
  Time ready_within = std::chrono::seconds(10);
  /// The physics is never further ahead of the timeline than this.
  Time physics_grain = std::chrono::milliseconds(1);
};

/// Options for one skill.
struct SessionOptions {
  RunOptions run;
  /// Chooses the station instant at which the skill begins, given the earliest possible one; not before it.
  /// Empty: the earliest.
  std::function<Time(Time earliest)> begin;
};

/// Owns the clock of its drivers and the physics. For one thread only.
class Station {
 public:
  /// The physics, and a pace, outlive the station.
  explicit Station(World& physics, Pace* pace = nullptr, StationOptions options = {});
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  Timeline& timeline() { return timeline_; }
  Time now() const { return timeline_.now(); }

  /// Drivers are commissioned before the station's first skill, prepared before a skill that uses them, and
  /// released before one that does not. They outlive the station's last use.
  void add(Driver& driver);
  /// A device that is not a driver is there only as long as the skill.
  void add(Device& device);

  /// Readies the devices, runs the skill from its time 0 to its end, closes the sessions. A device in trouble
  /// refuses the skill before it begins, with the reason. Never throws because of skill, devices or physics.
  /// While a skill runs, a call from inside a device is refused. In real time (RunOptions::real_time) the
  /// calling thread moves the physics and the devices by the wall clock, without the kernel's lock. A pace
  /// must then be one of real time (a factor of 1).
  Outcome run(Skill& skill, std::span<const ParameterValue> parameters = {},
              const SessionOptions& options = {});

  /// Lets time pass; drivers go on serving their devices. Throws what the physics or a driver throws.
  void idle(Time time);

  /// When the last skill began, in station time.
  Time begun() const { return begun_; }

 private:
  class RunWorld;
  class WorldApart;

  void pass_to(Time when);
  void go_to(Time when, const RunControl* control = nullptr);
  void commission(const RunOptions& options);
  void make_ready(const Skill& skill, const RunOptions& options);
  std::string pass_until(const std::function<std::string()>& unfinished, const RunOptions& options);
  std::vector<Driver*> drivers_for(const Skill& skill, bool used) const;

  World& physics_;
  Pace* pace_;
  StationOptions options_;
  Timeline timeline_;
  std::vector<Driver*> drivers_;
  std::vector<Device*> devices_;  // the drivers, too
  Time begun_{};
  bool running_ = false;
  bool commissioned_ = false;
};

}  // namespace pal::runtime::drivers
