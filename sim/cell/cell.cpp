#include "sim/cell/cell.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "runtime/drivers/alter/driver.hpp"
#include "runtime/drivers/force_torque/driver.hpp"
#include "runtime/drivers/gripper/driver.hpp"
#include "runtime/drivers/pendant/driver.hpp"
#include "runtime/drivers/range_finder/driver.hpp"
#include "runtime/drivers/val/alter_opener.hpp"
#include "sim/cell/corrected_arm.hpp"
#include "sim/cell/device_views.hpp"
#include "sim/devices/alter_emulator.hpp"
#include "sim/devices/force_torque_emulator.hpp"
#include "sim/random.hpp"
#include "sim/val/controller.hpp"

namespace pal::sim {
namespace {

ForceTorqueEmulatorOptions sensor_options(const CellOptions& cell, const MachineOptions& machine) {
  ForceTorqueEmulatorOptions options;
  options.seed = cell.seed;
  if (machine.noise) {
    options.most_offset = 1.5, options.most_torque_offset = 0.08;
    options.most_drift = 0.01, options.most_torque_drift = 0.0005;
  } else {
    options.force_noise = options.torque_noise = 0, options.z_step = 1;
  }
  if (cell.times == runtime::CostPolicy::worst) options.shortest_conversion = options.longest_conversion;
  if (cell.times == runtime::CostPolicy::best) options.longest_conversion = options.shortest_conversion;
  return options;
}

runtime::drivers::force_torque::Load axes_of(const Wrench& wrench) {
  return {wrench.force.x(),  wrench.force.y(),  wrench.force.z(),
          wrench.torque.x(), wrench.torque.y(), wrench.torque.z()};
}

GripperEmulatorOptions gripper_options(const CellOptions& cell) {
  GripperEmulatorOptions options;
  options.seed = cell.seed;
  if (cell.times == runtime::CostPolicy::worst) options.shortest_wait = options.longest_wait;
  if (cell.times == runtime::CostPolicy::best) options.longest_wait = options.shortest_wait;
  return options;
}

runtime::Time phase_of(const CellOptions& options) {
  Random random(options.seed, 1);
  return options.phase.value_or(random.between(runtime::Time::zero(), alter_period));
}

/// A line with an emulated device at its far end and a driver at its near one.
template <class Emulator, class Driver>
struct Attached {
  template <class MakeEmulator, class MakeDriver>
  Attached(runtime::drivers::Timeline& timeline, runtime::drivers::LineSpeed speed,
           std::unique_ptr<runtime::drivers::Carrier> through, MakeEmulator emulator_at, MakeDriver driver_at)
      : carrier(std::move(through)),
        wire(timeline, speed, carrier.get()),
        emulator(emulator_at(wire.b())),
        driver(driver_at(wire.a())) {}

  std::unique_ptr<runtime::drivers::Carrier> carrier;
  runtime::drivers::Wire wire;
  std::unique_ptr<Emulator> emulator;
  std::unique_ptr<Driver> driver;
};

constexpr const char* force_torque_name = "force-torque";

bool uses(const runtime::Skill& skill, std::string_view device) {
  const auto devices = skill.wiring().devices;
  return std::find(devices.begin(), devices.end(), device) != devices.end();
}

/// What the motions of a skill are relative to: its parameter `frame`, if it has one; otherwise the tool.
runtime::drivers::alter::Mode mode_of(const runtime::Skill& skill,
                                      std::span<const runtime::ParameterValue> parameters) {
  double frame = 2;
  for (const runtime::ParameterSpec& each : skill.description().parameters)
    if (each.name == "frame" && each.type == runtime::ParameterType::integer) frame = each.default_value;
  for (const runtime::ParameterValue& each : parameters)
    if (each.name == "frame" && !each.text) frame = each.value;
  return {.world = frame == 1, .cumulative = true, .joints = frame == 0};
}

/// The station's physics as an observer sees it; null: none.
std::unique_ptr<runtime::World> watched(const CellOptions& options, Workcell& workcell) {
  return options.watch ? options.watch(workcell) : nullptr;
}

runtime::World& physics(std::unique_ptr<runtime::World>& world, Workcell& workcell) {
  if (world) return *world;
  return workcell;
}

}  // namespace

// In this order: what comes later uses what stands before it.
struct Cell::Parts {
  Parts(const Scene& scene, const CellOptions& options)
      : fixed_noise(options.seed, 7),
        workcell(scene, {.raise = options.raise,
                         .start = options.start,
                         .machine_seed = options.machine_seed,
                         .keep_log = options.keep_log}),
        world(watched(options, workcell)),
        station(physics(world, workcell), options.pace),
        arm(workcell),
        alter_carrier(through(options)),
        alter_wire(station.timeline(), runtime::drivers::alter::line, alter_carrier.get()),
        alter_port(station.timeline(), alter_wire.b(), arm),
        val(
            station.timeline(), val::terminal_line, through(options),
            [&](runtime::drivers::Link& link) {
              return std::make_unique<val::Controller>(station.timeline(), link, workcell, &alter_port);
            },
            [&](runtime::drivers::Link& link) {
              return std::make_unique<runtime::drivers::ValDriver>(station.timeline(), link);
            }),
        opener(*val.driver),
        alter(station.timeline(), alter_wire.a(), opener) {
    val.emulator->store().locations = workcell.locations();
    attach(*val.driver, val.wire);
    attach(alter, alter_wire);
    station.add(pendant);
    attach_force_torque(options);
    if (workcell.tool_kind() == ToolKind::gripper) attach_gripper(options);
    if (workcell.tool_kind() == ToolKind::range_finder) attach_range_finder(options);
    for (const PlannedFault& fault : faults = options.faults) line_of(fault);
    at_begin = options.at_begin;
    arm_fault = workcell.on_fault([this](const ArmFault&) { alter_port.arm_has_stopped(); });
  }

  static std::unique_ptr<runtime::drivers::Carrier> through(const CellOptions& options) {
    return options.carrier ? options.carrier() : nullptr;
  }

  void attach(runtime::drivers::Driver& driver, runtime::drivers::Wire& wire) {
    station.add(driver);
    lines.push_back({driver.name(), &wire});
  }

  void attach_force_torque(const CellOptions& options) {
    const ForceTorqueEmulatorOptions sensor = sensor_options(options, workcell.machine());
    force_torque.emplace(
        station.timeline(), sensor.line, through(options),
        [&](runtime::drivers::Link& link) {
          return std::make_unique<ForceTorqueEmulator>(
              station.timeline(), link, [this] { return workcell.wrench(); }, sensor);
        },
        [&](runtime::drivers::Link& link) {
          runtime::drivers::ForceTorqueDriverOptions driver;
          driver.tool_weight = [this] { return axes_of(workcell.tool_weight()); };
          return std::make_unique<runtime::drivers::ForceTorqueDriver>(station.timeline(), link, driver);
        });
    attach(*force_torque->driver, force_torque->wire);
  }

  void attach_gripper(const CellOptions& options) {
    gripper.emplace(
        station.timeline(), runtime::drivers::gripper::line, through(options),
        [&](runtime::drivers::Link& link) {
          return std::make_unique<GripperEmulator>(
              station.timeline(), link, [this] { return gripper_state(workcell); }, gripper_options(options));
        },
        [&](runtime::drivers::Link& link) {
          return std::make_unique<runtime::drivers::GripperDriver>(station.timeline(), link);
        });
    attach(*gripper->driver, gripper->wire);
  }

  void attach_range_finder(const CellOptions& options) {
    range_finder.emplace(
        station.timeline(), runtime::drivers::range_finder::line, through(options),
        [&](runtime::drivers::Link& link) {
          RangeFinderEmulatorOptions finder;
          finder.seed = options.seed;
          if (!workcell.machine().noise) finder.error_scale = 0;
          return std::make_unique<RangeFinderEmulator>(station.timeline(), link, range_view(workcell),
                                                       finder);
        },
        [&](runtime::drivers::Link& link) {
          return std::make_unique<runtime::drivers::RangeFinderDriver>(station.timeline(), link);
        });
    attach(*range_finder->driver, range_finder->wire);
  }

  runtime::drivers::Driver* driver_of(const std::string& device) {
    if (force_torque && force_torque->driver->name() == device) return force_torque->driver.get();
    if (gripper && gripper->driver->name() == device) return gripper->driver.get();
    if (range_finder && range_finder->driver->name() == device) return range_finder->driver.get();
    return nullptr;
  }

  Sensed sense_device(const std::string& sensor, const Source& source, const runtime::RunControl* control) {
    runtime::drivers::Driver* driver = driver_of(source.device);
    if (driver == nullptr) return {{}, "the cell has no " + source.device, false};
    const bool prepare = !started.contains(source.device) || !driver->trouble().empty();
    const Answer answer = ask(station, *driver, source.message, prepare, control);
    if (!answer.fields) {
      started.erase(source.device);
      return {{}, answer.problem, answer.stopped};
    }
    started.insert(source.device);
    std::vector<double> fields = *answer.fields;
    if (source.device == force_torque_name)
      for (std::size_t i = 0; i < std::min(fields.size(), zero.size()); ++i) fields[i] -= zero[i];
    const auto value = quantity(sensor, fields);
    return {value, value ? "" : source.device + ": sees nothing", false};
  }

  std::optional<std::string> set_zero(const std::string& sensor, const runtime::RunControl* control) {
    const auto source = source_of(sensor);
    if (!source) return "there is no sensor '" + sensor + "' that can be zeroed";
    if (source->device != force_torque_name) return "the sensor '" + sensor + "' has no zero to be set";
    const std::vector<double> before = std::exchange(zero, {});
    constexpr int readings = 20;
    std::vector<double> sum;
    for (int i = 0; i < readings; ++i) {
      runtime::drivers::Driver& driver = *driver_of(source->device);
      const bool prepare = !started.contains(source->device) || !driver.trouble().empty();
      const Answer answer = ask(station, driver, source->message, prepare, control);
      if (!answer.fields) {
        zero = before;
        return answer.stopped ? "stopped" : answer.problem;
      }
      started.insert(source->device);
      sum.resize(answer.fields->size(), 0);
      for (std::size_t axis = 0; axis < sum.size(); ++axis) sum[axis] += (*answer.fields)[axis] / readings;
    }
    zero = std::move(sum);
    return std::nullopt;
  }

  Sensed sense_fixed(const std::string& sensor) {
    const runtime::Time now = station.now();
    station.idle((now / fixed_sensor_period + 1) * fixed_sensor_period - now);
    const auto value = read_fixed_sensor(workcell, sensor, fixed_noise);
    return {value, value ? "" : "there is no sensor '" + sensor + "', or it sees nothing", false};
  }

  runtime::drivers::Wire& line_of(const PlannedFault& fault) {
    std::string names;
    for (const Line& line : lines) {
      if (line.device == fault.device) return *line.wire;
      names += (names.empty() ? "" : ", ") + line.device;
    }
    throw NoSuchDevice("there is no device '" + fault.device + "' to go wrong; there are " + names,
                       fault.line);
  }

  void plan_faults(runtime::Time begin) {
    if (std::exchange(faults_planned, true)) return;
    for (const PlannedFault& fault : faults)
      station.timeline().at(begin + fault.at, [this, fault] {
        bring_about(fault, line_of(fault));
        std::erase_if(faults, [&](const PlannedFault& other) { return other.line == fault.line; });
      });
  }

  Random fixed_noise;
  std::vector<double> zero;       // what the force-torque sensor showed when it was zeroed, by axis
  std::set<std::string> started;  // devices that a skill or a reading has started
  Workcell workcell;
  std::unique_ptr<runtime::World> world;
  runtime::drivers::Station station;
  CorrectedArm arm;
  std::unique_ptr<runtime::drivers::Carrier> alter_carrier;
  runtime::drivers::Wire alter_wire;
  AlterEmulator alter_port;
  Attached<val::Controller, runtime::drivers::ValDriver> val;
  runtime::drivers::val::AlterOpener opener;
  runtime::drivers::AlterDriver alter;
  runtime::drivers::PendantDriver pendant;
  std::optional<Attached<ForceTorqueEmulator, runtime::drivers::ForceTorqueDriver>> force_torque;
  std::optional<Attached<GripperEmulator, runtime::drivers::GripperDriver>> gripper;
  std::optional<Attached<RangeFinderEmulator, runtime::drivers::RangeFinderDriver>> range_finder;
  std::vector<Line> lines;
  std::vector<PlannedFault> faults;  // that have not come
  bool faults_planned = false;
  std::function<void(runtime::Time)> at_begin;
  std::shared_ptr<void> arm_fault;
};

Cell::Cell(const Scene& scene, const CellOptions& options)
    : phase_(phase_of(options)), parts_(std::make_unique<Parts>(scene, options)) {}

Cell::~Cell() = default;

runtime::Outcome Cell::run(runtime::Skill& skill, std::span<const runtime::ParameterValue> parameters,
                           const runtime::RunOptions& options) {
  runtime::drivers::SessionOptions session;
  session.run = options;
  // A skill that drives by VAL as well says itself when corrections are taken.
  parts_->alter.leave_opening_to_skill(uses(skill, "val"));
  parts_->alter.use(mode_of(skill, parameters));
  session.begin = [this](runtime::Time earliest) {
    const runtime::Time begin = parts_->alter.next_tick(earliest + phase_) - phase_;
    parts_->plan_faults(begin);
    if (parts_->at_begin) parts_->at_begin(begin);
    return begin;
  };
  for (const std::string_view device : skill.wiring().devices) parts_->started.emplace(device);
  return parts_->station.run(skill, parameters, session);
}

std::vector<SensorSpec> Cell::sensors() const {
  return sensors_of(parts_->workcell);
}

Cell::Sensed Cell::sense(const std::string& sensor, const runtime::RunControl* control) {
  if (const auto source = source_of(sensor)) return parts_->sense_device(sensor, *source, control);
  return parts_->sense_fixed(sensor);
}

std::optional<std::string> Cell::zero(const std::string& sensor, const runtime::RunControl* control) {
  return parts_->set_zero(sensor, control);
}

void Cell::rest(runtime::Time time) {
  while (!parts_->workcell.idle()) parts_->station.idle(alter_period);
  parts_->station.idle(time);
}

Workcell& Cell::workcell() {
  return parts_->workcell;
}

runtime::drivers::Station& Cell::station() {
  return parts_->station;
}

const std::vector<Cell::Line>& Cell::lines() const {
  return parts_->lines;
}

const std::vector<PlannedFault>& Cell::faults_to_come() const {
  return parts_->faults;
}

val::Store& Cell::val_store() {
  return parts_->val.emulator->store();
}

runtime::drivers::PendantDriver& Cell::pendant() {
  return parts_->pendant;
}

runtime::drivers::ValDriver& Cell::val_driver() {
  return *parts_->val.driver;
}

}  // namespace pal::sim
