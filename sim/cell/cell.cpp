#include "sim/cell/cell.hpp"

#include <utility>

#include "sim/cell/workcell_arm.hpp"
#include "sim/devices/alter_emulator.hpp"
#include "sim/devices/force_torque_sensor.hpp"
#include "sim/random.hpp"

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
        force_torque(workcell, sensor_options(options)) {
    station.add(alter);
    station.add(force_torque);
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

runtime::Wire& Cell::alter_line() {
  return parts_->alter_wire;
}

}  // namespace pal::sim
