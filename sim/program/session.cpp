#include "sim/program/session.hpp"

#include <algorithm>
#include <array>

#include "sim/devices/alter_port.hpp"
#include "sim/devices/force_torque_sensor.hpp"

namespace pal::workcell {
namespace {

constexpr runtime::Time rest = std::chrono::milliseconds(400);

sim::ForceTorqueOptions sensor_options(const Session& session) {
  sim::ForceTorqueOptions options;
  options.seed = session.seed;
  if (session.times == runtime::CostPolicy::worst) options.shortest = options.longest;
  if (session.times == runtime::CostPolicy::best) options.longest = options.shortest;
  return options;
}

}  // namespace

SessionResult run_session(runtime::Skill& skill, const Session& session) {
  sim::Workcell workcell(session.scene, {.raise = session.raise});
  sim::AlterPort alter(workcell, {.phase = session.phase, .seed = session.seed});
  sim::ForceTorqueSensor sensor(workcell, sensor_options(session));
  const std::array<runtime::Device*, 2> devices{&alter, &sensor};
  runtime::Dispatcher dispatcher(devices, workcell);

  SessionResult result;
  runtime::RunOptions options;
  options.costs = session.times;
  options.seed = session.seed;
  result.outcome = dispatcher.run(skill, session.parameters, options);
  result.phase = alter.phase();

  while (!workcell.idle()) workcell.advance_to(workcell.now() + sim::alter_period);
  workcell.advance_to(workcell.now() + rest);
  result.log = workcell.log();
  for (const sim::Sample& sample : result.log)
    result.peak_force = std::max(result.peak_force, sample.contact_force);
  if (!result.log.empty()) result.resting_force = result.log.back().contact_force;
  if (session.picture) result.picture = sim::take_picture(workcell);
  return result;
}

std::optional<double> parameter_value(const runtime::Skill& skill, const Session& session,
                                      std::string_view name) {
  for (const runtime::ParameterValue& parameter : session.parameters)
    if (parameter.name == name) return parameter.value;
  for (const runtime::ParameterSpec& parameter : skill.description().parameters)
    if (parameter.name == name) return parameter.default_value;
  return std::nullopt;
}

std::string text_parameter(const runtime::ParameterSpec& parameter, const Session& session) {
  std::string text(parameter.default_text);
  for (const runtime::ParameterValue& value : session.parameters)
    if (value.name == parameter.name) text = value.text.value_or(text);
  return text;
}

}  // namespace pal::workcell
