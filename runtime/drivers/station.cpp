#include "runtime/drivers/station.hpp"

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <utility>

#include "runtime/drivers/apart.hpp"
#include "runtime/executives/real_time/clock.hpp"
#include "runtime/kernel/thrown.hpp"

namespace pal::runtime::drivers {
namespace {

constexpr Time look_outside_each = std::chrono::seconds(1);

/// Sets a flag for as long as it lives.
class Raised {
 public:
  explicit Raised(bool& flag) : flag_(flag) { flag_ = true; }
  Raised(const Raised&) = delete;
  Raised& operator=(const Raised&) = delete;
  ~Raised() { flag_ = false; }

 private:
  bool& flag_;
};

bool uses(const Skill& skill, const Device& device) {
  const auto devices = skill.wiring().devices;
  return std::find(devices.begin(), devices.end(), device.name()) != devices.end();
}

bool stopping(const RunControl* control) {
  return control != nullptr && control->stopping();
}

}  // namespace

/// The station as a run sees it: time 0 is where the skill begins.
class Station::RunWorld final : public World {
 public:
  explicit RunWorld(Station& station) : station_(station) {}
  void advance_to(Time when) override { station_.pass_to(station_.begun_ + when); }
  Time next_event() override {
    Time next = station_.timeline_.next();
    // Something may come in from outside at any time: as long as it may, a run is not at its end.
    if (station_.pace_ != nullptr) next = std::min(next, station_.timeline_.now() + look_outside_each);
    return next == Timeline::never ? Time::max() : next - station_.begun_;
  }
  Time wait_until(Time when) override {
    if (station_.pace_ == nullptr) return when;
    return station_.pace_->wait_until(station_.begun_ + when) - station_.begun_;
  }
  Time beat() override { return station_.options_.physics_grain; }
  void resumed() override {
    if (station_.pace_ != nullptr) station_.pace_->resumed(station_.timeline_.now());
  }

 private:
  Station& station_;
};

/// The same for a run in real time: one thread moves physics, timeline and devices, apart from the kernel.
class Station::WorldApart final : public World {
 public:
  explicit WorldApart(Station& station) : station_(station), letters_([this] { wake(); }) {
    for (Device* device : station.devices_) {
      apart_.emplace_back(*device, station.timeline_, station.begun_, letters_);
      devices_.push_back(&apart_.back());
    }
  }
  std::span<Device* const> devices() const { return devices_; }

  bool apart() const override { return true; }
  void advance_to(Time when) override {
    keep_in_step(when);
    while (letters_.read(when, letter_)) {
      station_.pass_to(std::max(station_.begun_ + letter_.when, station_.timeline_.now()));
      letter_.device->take(letter_);
    }
    station_.pass_to(station_.begun_ + when);
  }
  Time next_event() override {
    const Time next = station_.timeline_.next();
    return next == Timeline::never ? Time::max() : next - station_.begun_;
  }
  Time beat() override { return station_.options_.physics_grain; }
  Time wait_until(Time when) override {
    if (!letters_.empty()) return when;
    if (station_.pace_ != nullptr)
      return station_.pace_->wait_until(station_.begun_ + when) - station_.begun_;
    sleeper_.sleep_until(origin_ + when);
    return when;
  }
  void wake() override {
    if (station_.pace_ != nullptr) {
      station_.pace_->wake();
    } else {
      sleeper_.wake();
    }
  }

 private:
  /// The run's clock is the monotonic one from some instant on. The pace is set by the first call.
  void keep_in_step(Time when) {
    if (origin_ == Time::max() && station_.pace_ != nullptr) station_.pace_->resumed(station_.begun_ + when);
    origin_ = std::min(origin_, monotonic_now() - when);
  }

  Station& station_;
  Sleeper sleeper_;
  Letters letters_;
  Letters::Letter letter_;
  std::deque<DeviceApart> apart_;
  std::vector<Device*> devices_;
  Time origin_ = Time::max();
};

Station::Station(World& physics, Pace* pace, StationOptions options)
    : physics_(physics), pace_(pace), options_(options) {}

void Station::add(Driver& driver) {
  drivers_.push_back(&driver);
  devices_.push_back(&driver);
}

void Station::add(Device& device) {
  devices_.push_back(&device);
}

// Time.

// In steps, so that what the physics brings about meets a clock that is not far behind.
void Station::pass_to(Time when) {
  const Time grain = options_.physics_grain;
  while (timeline_.now() < when || timeline_.next() <= when) {
    const Time grid = (timeline_.now() / grain + 1) * grain;
    const Time stop = std::min({when, std::max(timeline_.next(), timeline_.now()), grid});
    physics_.advance_to(stop);
    timeline_.advance_to(stop);
  }
}

void Station::go_to(Time when, const RunControl* control) {
  do {
    const Time target = std::min(when, timeline_.next());
    pass_to(pace_ == nullptr ? target : pace_->wait_until(target));
  } while (timeline_.now() < when && !stopping(control));
}

void Station::idle(Time time) {
  go_to(timeline_.now() + time);
}

// Skills.

std::vector<Driver*> Station::drivers_for(const Skill& skill, bool used) const {
  std::vector<Driver*> result;
  for (Driver* driver : drivers_)
    if (uses(skill, *driver) == used) result.push_back(driver);
  return result;
}

// Lets time pass until `unfinished` names nothing any more. Returns what it names when time is over.
std::string Station::pass_until(const std::function<std::string()>& unfinished, const RunOptions& options) {
  const Time limit = timeline_.now() + options_.ready_within;
  std::string name = unfinished();
  while (!name.empty() && timeline_.now() < limit && !stopping(options.control)) {
    go_to(std::min(limit, timeline_.next()), options.control);
    name = unfinished();
  }
  return name;
}

// Once, before the first skill.
void Station::commission(const RunOptions& options) {
  if (std::exchange(commissioned_, true)) return;
  std::vector<Driver*> busy;
  for (Driver* driver : drivers_)
    if (driver->commission()) busy.push_back(driver);
  pass_until(
      [&] {
        const auto at = std::find_if_not(busy.begin(), busy.end(), [](auto* d) { return d->ready(); });
        return at == busy.end() ? std::string() : (*at)->name();
      },
      options);
}

void Station::make_ready(const Skill& skill, const RunOptions& options) {
  const std::vector<Driver*> used = drivers_for(skill, true);
  const std::vector<Driver*> unused = drivers_for(skill, false);
  // First what is in the way.
  for (Driver* driver : unused) driver->release();
  std::string late = pass_until(
      [&] {
        const auto at = std::find_if_not(unused.begin(), unused.end(), [](auto* d) { return d->released(); });
        return at == unused.end() ? std::string() : (*at)->name();
      },
      options);
  if (!late.empty()) throw std::runtime_error(late + ": cannot be given up; it does not come to its end");
  for (Driver* driver : used) driver->prepare();
  late = pass_until(
      [&] {
        const auto at = std::find_if_not(used.begin(), used.end(), [](auto* d) { return d->ready(); });
        return at == used.end() ? std::string() : (*at)->name();
      },
      options);
  if (stopping(options.control)) throw std::runtime_error("stopped on request");
  for (const Driver* driver : used)
    if (!driver->trouble().empty()) throw std::runtime_error(driver->name() + ": " + driver->trouble());
  if (!late.empty()) throw std::runtime_error(late + ": is not ready in time; is it switched on?");
}

Outcome Station::run(Skill& skill, std::span<const ParameterValue> parameters,
                     const SessionOptions& options) {
  if (running_) return refused(skill, "another skill is running; a station runs one at a time");
  const Raised running(running_);
  try {
    commission(options.run);
    make_ready(skill, options.run);
    begun_ = timeline_.now() + Time(1);
    if (options.begin) begun_ = std::max(begun_, options.begin(begun_));
    // What is due at the beginning itself happens in the skill.
    go_to(begun_ - Time(1), options.run.control);
  } catch (...) {
    return refused(skill, what_was_thrown());
  }
  if (options.run.real_time) {
    WorldApart world(*this);
    return Dispatcher(world.devices(), world).run(skill, parameters, options.run);
  }
  RunWorld world(*this);
  return Dispatcher(devices_, world).run(skill, parameters, options.run);
}

}  // namespace pal::runtime::drivers
