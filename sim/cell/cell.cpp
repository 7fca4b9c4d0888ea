#include "sim/cell/cell.hpp"

#include <algorithm>
#include <utility>

#include "runtime/drivers/alter/driver.hpp"
#include "runtime/drivers/force_torque/driver.hpp"
#include "runtime/drivers/gripper/driver.hpp"
#include "runtime/drivers/range_finder/driver.hpp"
#include "runtime/drivers/val/val_driver.hpp"
#include "sim/cell/corrected_arm.hpp"
#include "sim/cell/emulated.hpp"
#include "sim/devices/alter_emulator.hpp"
#include "sim/random.hpp"

namespace pal::sim {
namespace {

/// Opens and closes ALTER as the real machine does: by VAL's lines.
class ValOpener final : public runtime::alter::Opener {
 public:
  explicit ValOpener(runtime::ValDriver& val) : val_(val) {}
  void open(const AlterMode& mode, Done done) override {
    const double figure = (mode.cumulative ? 1 : 0) + (mode.world ? 2 : 0);
    submit(runtime::val::Verb::open_alter, figure, std::move(done));
  }
  void close(Done done) override { submit(runtime::val::Verb::close_alter, 0, std::move(done)); }

 private:
  void submit(runtime::val::Verb verb, double figure, Done done) {
    runtime::val::Command command{.verb = verb, .location = {}, .second = {}};
    command.figures[0] = figure;
    val_.submit(std::move(command), [done = std::move(done)](const runtime::val::Answer& answer) {
      done(answer.ok ? "" : answer.text);
    });
  }

  runtime::ValDriver& val_;
};

runtime::Time phase_of(const CellOptions& options) {
  Random random(options.seed, 1);
  return options.phase.value_or(random.between(runtime::Time::zero(), alter_period));
}

/// A wire and what carries its bytes.
struct CarriedLine {
  CarriedLine(runtime::Timeline& timeline, runtime::LineSpeed speed, const CellOptions& options)
      : carrier(options.carrier ? options.carrier() : nullptr), wire(timeline, speed, carrier.get()) {}
  std::unique_ptr<runtime::Carrier> carrier;
  runtime::Wire wire;
};

/// A line with an emulated device at its far end and a driver at its near one.
template <class Driver>
struct Attached {
  template <class Make>
  Attached(runtime::Timeline& timeline, runtime::LineSpeed speed, const CellOptions& options, Make emulate)
      : line(timeline, speed, options), emulated(emulate(line.wire.b())), driver(timeline, line.wire.a()) {}
  CarriedLine line;
  std::shared_ptr<void> emulated;
  Driver driver;
};

bool uses(const runtime::Skill& skill, std::string_view device) {
  const auto devices = skill.wiring().devices;
  return std::find(devices.begin(), devices.end(), device) != devices.end();
}

/// The station's physics: the workcell, or what looks on.
runtime::World& physics(const std::unique_ptr<runtime::World>& watched, Workcell& workcell) {
  if (watched) return *watched;
  return workcell;
}

}  // namespace

// In this order: what comes later uses what stands before it.
struct Cell::Parts {
  Parts(const Scene& scene, const CellOptions& options)
      : workcell(scene, {.raise = options.raise}),
        watched(options.watch ? options.watch(workcell) : nullptr),
        station(physics(watched, workcell), options.pace),
        arm(workcell),
        alter_line(station.timeline(), runtime::alter::line, options),
        alter_port(station.timeline(), alter_line.wire.b(), arm),
        val_line(station.timeline(), val_speed, options),
        val_controller(workcell, station.timeline(), val_line.wire.b(), &alter_port),
        val(station.timeline(), val_line.wire.a()),
        opener(val),
        alter(station.timeline(), alter_line.wire.a(), opener),
        force_torque(station.timeline(), force_torque_speed, options, [&](runtime::Link& link) {
          return emulate_force_torque(station.timeline(), link, workcell, options.seed, options.times);
        }) {
    add(alter, alter_line.wire);
    add(force_torque.driver, force_torque.line.wire);
    add(val, val_line.wire);
    runtime::Timeline& timeline = station.timeline();
    if (workcell.tool_kind() == ToolKind::gripper) {
      gripper.emplace(timeline, gripper_speed, options, [&](runtime::Link& link) {
        return emulate_gripper(timeline, link, workcell, options.seed, options.times);
      });
      add(gripper->driver, gripper->line.wire);
    }
    if (workcell.tool_kind() == ToolKind::range_finder) {
      range_finder.emplace(timeline, runtime::range_finder::line, options, [&](runtime::Link& link) {
        return emulate_range_finder(timeline, link, workcell, options.seed);
      });
      add(range_finder->driver, range_finder->line.wire);
    }
    arm_fault = workcell.on_fault([this](const ArmFault&) { alter_port.arm_has_stopped(); });
  }

  void add(runtime::Driver& driver, runtime::Wire& wire) {
    station.add(driver);
    lines.push_back({driver.name(), &wire});
  }

  Workcell workcell;
  std::unique_ptr<runtime::World> watched;
  runtime::Station station;
  CorrectedArm arm;
  CarriedLine alter_line;
  AlterEmulator alter_port;
  CarriedLine val_line;
  EmulatedVal val_controller;
  runtime::ValDriver val;
  ValOpener opener;
  runtime::AlterDriver alter;
  Attached<runtime::ForceTorqueDriver> force_torque;
  std::optional<Attached<runtime::GripperDriver>> gripper;
  std::optional<Attached<runtime::RangeFinderDriver>> range_finder;
  std::vector<Line> lines;
  std::shared_ptr<void> arm_fault;
};

Cell::Cell(const Scene& scene, const CellOptions& options)
    : phase_(phase_of(options)), parts_(std::make_unique<Parts>(scene, options)) {}

Cell::~Cell() = default;

runtime::Outcome Cell::run(runtime::Skill& skill, std::span<const runtime::ParameterValue> parameters,
                           const runtime::RunOptions& options) {
  runtime::SessionOptions session;
  session.run = options;
  // Who drives by VAL as well says when corrections are taken.
  parts_->alter.leave_opening_to_skill(uses(skill, "val"));
  session.begin = [this](runtime::Time earliest) {
    return parts_->alter.next_tick(earliest + phase_) - phase_;
  };
  return parts_->station.run(skill, parameters, session);
}

void Cell::rest(runtime::Time time) {
  while (!parts_->workcell.idle()) parts_->station.idle(alter_period);
  parts_->station.idle(time);
}

Workcell& Cell::workcell() {
  return parts_->workcell;
}

runtime::Station& Cell::station() {
  return parts_->station;
}

const std::vector<Cell::Line>& Cell::lines() const {
  return parts_->lines;
}

val::Store& Cell::taught() {
  return parts_->val_controller.machine().store;
}

}  // namespace pal::sim
