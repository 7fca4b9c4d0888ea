// The workcell as a station: physics, emulated devices, the lines to them, and the drivers at the near ends.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/drivers/pendant/driver.hpp"
#include "runtime/drivers/station.hpp"
#include "runtime/drivers/val/driver.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/cell/fault_plan.hpp"
#include "sim/cell/sensors.hpp"
#include "sim/scene.hpp"
#include "sim/val/store.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

struct CellOptions {
  /// How much higher than in the scene the tool starts, mm.
  double raise = 0;
  /// Where the joints start, rad; not given: as the scene says.
  std::optional<Joints> start;
  /// The seed of everything that devices draw.
  std::uint64_t seed = 1;
  /// The seed of the machine, if it is not the scene's (MachineOptions::seed).
  std::optional<std::uint64_t> machine_seed;
  /// False: the workcell's log holds the last sample only.
  bool keep_log = true;
  /// Which times of their intervals devices take.
  runtime::CostPolicy times = runtime::CostPolicy::random;
  /// From the beginning of a skill to ALTER's first request, within [0, 28 ms]; drawn by the seed if not
  /// given.
  std::optional<runtime::Time> phase;
  /// How station time goes by; null: it is virtual. Outlives the cell.
  runtime::drivers::Pace* pace = nullptr;
  /// What carries the bytes of a device's line: empty, or gives null: they stay in the process.
  std::function<std::unique_ptr<runtime::drivers::Carrier>()> carrier;
  /// Observes the physics while it moves; empty: no observer.
  std::function<std::unique_ptr<runtime::World>(Workcell&)> watch;
  /// Called shortly before a skill begins, with the station time of its beginning. Empty: nothing is called.
  std::function<void(runtime::Time)> at_begin;
  /// Faults of devices' lines; they happen once. Their times count from the beginning of the first skill.
  std::vector<PlannedFault> faults;
};

/// Devices: val, alter, force-torque, pendant; gripper or range-finder where the scene's tool is one. ALTER
/// is opened for a skill that uses it, except for one that uses val, too: that opens and closes it itself, by
/// VAL's commands. What a skill's corrections are relative to is said by its integer parameter `frame`: 0 the
/// joints, 1 frame 0, 2 the tool; the tool if it has none.
class Cell {
 public:
  /// Throws SceneError; NoSuchDevice for a fault of a device that the cell does not have.
  explicit Cell(const Scene& scene, const CellOptions& options = {});
  ~Cell();
  Cell(const Cell&) = delete;
  Cell& operator=(const Cell&) = delete;

  /// Runs the skill; it begins so that ALTER's first request comes at the phase. As Station::run.
  runtime::Outcome run(runtime::Skill& skill, std::span<const runtime::ParameterValue> parameters = {},
                       const runtime::RunOptions& options = {});
  /// Until the arm has made all motions that it accepted, and for `time` more.
  void rest(runtime::Time time);

  /// The sensors that sense() can read.
  std::vector<SensorSpec> sensors() const;
  /// Reads a sensor between skills, by its device's line or at a fixed sensor's next measurement; time
  /// passes. The force-torque sensor counts from free air, without the tool's weight. Stopped by `control`,
  /// which may be null. Never throws for what devices do.
  struct Sensed {
    std::optional<double> value;
    std::string problem;  // why there is no value
    bool stopped = false;
  };
  Sensed sense(const std::string& sensor, const runtime::RunControl* control = nullptr);
  /// What the force-torque sensor shows now, on all its axes, counts as zero for sense() from now on;
  /// `sensor` is any of them. The mean of some readings; time passes. Skills do not see it. The answer says
  /// why it cannot be; nothing: it is done.
  std::optional<std::string> zero(const std::string& sensor, const runtime::RunControl* control = nullptr);

  runtime::Time phase() const { return phase_; }
  Workcell& workcell();
  runtime::drivers::Station& station();

  /// The lines by the names of their devices: for faults on demand.
  struct Line {
    std::string device;
    runtime::drivers::Wire* wire = nullptr;
  };
  const std::vector<Line>& lines() const;
  /// Of CellOptions::faults, those that have not happened yet.
  const std::vector<PlannedFault>& faults_to_come() const;

  /// Locations that skills can name, and programs: VAL's memory. At first it has the scene's locations.
  val::Store& val_store();
  runtime::drivers::ValDriver& val_driver();
  /// What a person holds to move the arm.
  runtime::drivers::PendantDriver& pendant();

 private:
  struct Parts;
  runtime::Time phase_;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pal::sim
