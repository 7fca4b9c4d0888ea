#include "sim/cell/cell.hpp"

#include <utility>

#include "runtime/drivers/gripper/driver.hpp"
#include "runtime/drivers/range_finder/driver.hpp"
#include "runtime/drivers/val/val_driver.hpp"
#include "sim/cell/workcell_arm.hpp"
#include "sim/devices/alter_emulator.hpp"
#include "sim/devices/force_torque_sensor.hpp"
#include "sim/devices/gripper_emulator.hpp"
#include "sim/devices/range_finder_emulator.hpp"
#include "sim/random.hpp"
#include "sim/val/terminal.hpp"
#include "sim/val/workcell_arm.hpp"

namespace pal::sim {
namespace {

/// Opens the emulated port without VAL between them.
class DirectOpener final : public runtime::alter::Opener {
 public:
  explicit DirectOpener(AlterControl& control) : control_(control) {}
  void open(const AlterMode& mode, Done done) override { done(control_.open(mode)); }
  void close(Done done) override { done(control_.close()); }

 private:
  AlterControl& control_;
};

ForceTorqueOptions sensor_options(const CellOptions& cell) {
  ForceTorqueOptions options;
  options.seed = cell.seed;
  if (cell.times == runtime::CostPolicy::worst) options.shortest = options.longest;
  if (cell.times == runtime::CostPolicy::best) options.longest = options.shortest;
  return options;
}

runtime::Time phase_of(const CellOptions& options) {
  Random random(options.seed, 1);
  return options.phase.value_or(random.between(runtime::Time::zero(), alter_period));
}

/// ALTER's port as VAL opens and closes it.
class AlterByVal final : public val::AlterControl {
 public:
  explicit AlterByVal(sim::AlterControl& port) : port_(port) {}
  std::string open(const val::AlterMode& mode) override { return port_.open({mode.world, mode.cumulative}); }
  std::string close() override { return port_.close(); }
  bool is_open() const override { return port_.is_open(); }

 private:
  sim::AlterControl& port_;
};

/// The controller's terminal and the driver that types at it.
struct ValLine {
  ValLine(Workcell& workcell, runtime::Timeline& timeline, AlterControl& port)
      : arm(workcell, timeline),
        hand(workcell, timeline),
        alter(port),
        machine{.timeline = timeline,
                .arm = arm,
                .hand = workcell.tool_kind() == ToolKind::gripper ? &hand : nullptr,
                .alter = &alter},
        wire(timeline, {.baud = 9600}),
        terminal(wire.b(), machine),
        driver(timeline, wire.a()) {}

  val::WorkcellArm arm;
  val::WorkcellHand hand;
  AlterByVal alter;
  val::Machine machine;
  runtime::Wire wire;
  val::Terminal terminal;
  runtime::ValDriver driver;
};

struct GripperLine {
  GripperLine(const Workcell& workcell, runtime::Timeline& timeline, std::uint64_t seed)
      : wire(timeline, {.baud = 9600}),
        emulator(
            timeline, wire.b(),
            [&workcell] {
              return GripperState{workcell.gripper_width(), workcell.gripper_force(), workcell.holds_part()};
            },
            {.seed = seed}),
        driver(timeline, wire.a()) {}

  runtime::Wire wire;
  GripperEmulator emulator;
  runtime::GripperDriver driver;
};

struct RangeFinderLine {
  RangeFinderLine(const Workcell& workcell, runtime::Timeline& timeline, std::uint64_t seed)
      : wire(timeline, runtime::range_finder::line),
        emulator(timeline, wire.b(),
                 {[&workcell] { return workcell.tool(); },
                  [&workcell](const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
                    return workcell.cast(origin, direction);
                  }},
                 {.seed = seed}),
        driver(timeline, wire.a()) {}

  runtime::Wire wire;
  RangeFinderEmulator emulator;
  runtime::RangeFinderDriver driver;
};

}  // namespace

// In this order: what comes later uses what stands before it.
struct Cell::Parts {
  Parts(const Scene& scene, const CellOptions& options)
      : workcell(scene, {.raise = options.raise}),
        looked_on(options.look_on ? options.look_on(workcell) : nullptr),
        station(looked_on ? *looked_on : workcell, options.pace),
        arm(workcell),
        alter_wire(station.timeline(), runtime::alter::line, options.alter_carrier),
        alter_port(station.timeline(), alter_wire.b(), arm),
        opener(alter_port),
        alter(station.timeline(), alter_wire.a(), opener),
        force_torque(workcell, sensor_options(options)),
        val(workcell, station.timeline(), alter_port) {
    station.add(alter);
    station.add(force_torque);
    station.add(val.driver);
    if (workcell.tool_kind() == ToolKind::gripper)
      station.add(gripper.emplace(workcell, station.timeline(), options.seed).driver);
    if (workcell.tool_kind() == ToolKind::range_finder)
      station.add(range_finder.emplace(workcell, station.timeline(), options.seed).driver);
  }

  Workcell workcell;
  std::unique_ptr<runtime::World> looked_on;
  runtime::Station station;
  WorkcellArm arm;
  runtime::Wire alter_wire;
  AlterEmulator alter_port;
  DirectOpener opener;
  runtime::AlterDriver alter;
  ForceTorqueSensor force_torque;
  ValLine val;
  std::optional<GripperLine> gripper;
  std::optional<RangeFinderLine> range_finder;
};

Cell::Cell(const Scene& scene, const CellOptions& options)
    : phase_(phase_of(options)), parts_(std::make_unique<Parts>(scene, options)) {}

Cell::~Cell() = default;

runtime::Outcome Cell::run(runtime::Skill& skill, std::span<const runtime::ParameterValue> parameters,
                           const runtime::RunOptions& options) {
  runtime::SessionOptions session;
  session.run = options;
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

runtime::AlterDriver& Cell::alter() {
  return parts_->alter;
}

val::Store& Cell::taught() {
  return parts_->val.machine.store;
}

runtime::Wire& Cell::alter_line() {
  return parts_->alter_wire;
}

}  // namespace pal::sim
