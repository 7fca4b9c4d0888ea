#include "programs/workcell/session/sweep.hpp"

#include <cmath>

#include "pal/trace/measure.hpp"

namespace pal::workcell {
namespace {

// Every statement of the skill method that sends the robot a motion.
std::vector<trace::StatementName> motion_statements(const trace::Trace& trace) {
  std::vector<trace::StatementName> names;
  for (const trace::Statement& statement : trace.statements)
    if (statement.module == "SM1" && statement.text.find("TXM( motion to") == 0)
      names.push_back({statement.module, statement.text, statement.line});
  return names;
}

bool has_condition(const trace::Trace& trace, const std::string& name) {
  for (const std::string& condition : trace.conditions)
    if (condition == name) return true;
  return false;
}

}  // namespace

std::vector<SweepRun> sweep(runtime::Skill& skill, const Session& session, int count) {
  const double speed = parameter_value(skill, session, "approach-speed").value_or(0);
  const double threshold = parameter_value(skill, session, "threshold").value_or(0);
  const double cycle = std::chrono::duration<double>(sim::alter_period).count();
  constexpr double golden =
      0.6180339887498949;  // its multiples fill [0, 1) evenly and in no step with i / count

  std::vector<SweepRun> runs;
  for (int i = 0; i < count; ++i) {
    Session one = session;
    one.phase = sim::alter_period * i / count;
    one.seed = session.seed + static_cast<std::uint64_t>(i);
    one.raise = session.raise + speed * cycle * std::fmod((i + 0.5) * golden, 1.0);
    one.picture = false;
    const SessionResult result = run_session(skill, one);

    SweepRun run;
    run.phase = *one.phase;
    run.raise = one.raise;
    run.seed = one.seed;
    run.completion = result.outcome.code;
    run.fault = result.outcome.fault;
    run.peak_force = result.peak_force;
    run.resting_force = result.resting_force;
    run.overshoot = result.peak_force - threshold;
    if (has_condition(result.outcome.trace, "pc-force")) {
      const auto ages =
          trace::ages(result.outcome.trace, "pc-force", motion_statements(result.outcome.trace));
      if (!ages.empty()) run.age = runtime::Time(ages.back().length_ns());
      if (const auto* greatest = trace::longest(ages))
        run.greatest_age = runtime::Time(greatest->length_ns());
    }
    runs.push_back(run);
  }
  return runs;
}

}  // namespace pal::workcell
