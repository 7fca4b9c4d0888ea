#include "programs/workcell/session/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <variant>

#include "pal/pan/dump.hpp"
#include "programs/pal/session/selection.hpp"
#include "programs/workcell/session/failure.hpp"

namespace pal::workcell {
namespace {

[[noreturn]] void refuse(const KnownSkill& skill, const std::string& why) {
  throw Failure(
      ExitStatus::usage, "--sweep", "'" + skill.name + "' cannot be swept: " + why,
      "sweep a skill with a requirement of the AGE of a condition, one parameter in mm/s and one in N");
}

std::string only_parameter_in(const std::string& unit, const KnownSkill& skill, const pan::Network& network) {
  const auto is_in = [&unit](const pan::Parameter& parameter) { return parameter.unit == unit; };
  const auto& all = network.skill.parameters;
  const auto found = std::find_if(all.begin(), all.end(), is_in);
  if (found == all.end()) refuse(skill, "it has no parameter in " + unit);
  if (std::count_if(all.begin(), all.end(), is_in) > 1) refuse(skill, "it has several parameters in " + unit);
  return found->name;
}

/// The statements of a run that are among `names`, in whatever line.
std::vector<trace::StatementName> statements_of(const trace::Trace& trace,
                                                const std::vector<trace::StatementName>& names) {
  std::vector<trace::StatementName> found;
  for (const trace::Statement& statement : trace.statements) {
    const bool asked = std::any_of(names.begin(), names.end(), [&](const trace::StatementName& name) {
      return name.module == statement.module && name.text == statement.text;
    });
    if (asked) found.push_back({statement.module, statement.text, statement.line});
  }
  return found;
}

bool has_condition(const trace::Trace& trace, const std::string& name) {
  for (const std::string& condition : trace.conditions)
    if (condition == name) return true;
  return false;
}

}  // namespace

SweepSubject sweep_subject(const KnownSkill& skill) {
  if (skill.pal_file.empty()) refuse(skill, "it names no PAL");
  std::ostringstream out, error;
  program::Session read;
  program::Selection selection;
  selection.files = {skill.pal_file};
  selection.environments = {skill.environment_file};
  selection.skill = skill.name;
  if (!program::read(selection, {out, error, *skill.texts}, read) || read.specification.skills.empty())
    refuse(skill, "its PAL is wrong");
  const pan::Network& network = read.specification.skills.front();
  SweepSubject subject;
  for (const pan::Requirement& requirement : network.requirements) {
    const auto* age = std::get_if<pan::Age>(&requirement.measure);
    const auto* condition = age == nullptr ? nullptr : std::get_if<pan::ConditionId>(&age->of);
    if (condition == nullptr) continue;
    subject.condition = network.conditions[condition->index()].name;
    for (const pan::StatementRef& at : age->at)
      subject.at.push_back(
          {network.modules[at.module.index()].name, pan::statement_text(network, at.module, at.node), 0});
    break;
  }
  if (subject.at.empty()) refuse(skill, "it requires no age of a condition");
  subject.speed = only_parameter_in("mm/s", skill, network);
  subject.threshold = only_parameter_in("N", skill, network);
  return subject;
}

std::vector<SweepRun> sweep(runtime::Skill& skill, const SweepSubject& subject, const Session& session,
                            int count) {
  const double speed = parameter_value(skill, session, subject.speed).value_or(0);
  const double threshold = parameter_value(skill, session, subject.threshold).value_or(0);
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
    if (has_condition(result.outcome.trace, subject.condition)) {
      const auto ages = trace::ages(result.outcome.trace, subject.condition,
                                    statements_of(result.outcome.trace, subject.at));
      if (!ages.empty()) run.age = runtime::Time(ages.back().length_ns());
      if (const auto* greatest = trace::longest(ages))
        run.greatest_age = runtime::Time(greatest->length_ns());
    }
    runs.push_back(run);
  }
  return runs;
}

}  // namespace pal::workcell
