#include "analyzer/replay/check_run.hpp"

#include "analyzer/replay/referee.hpp"

namespace pal::analyzer::rules {
namespace {

/// Whether the tables of the run are those of the problem; the first difference, or nothing.
std::string tables_differ(const Problem& problem, const trace::Trace& run) {
  if (run.skill != problem.skill) return "the run is one of skill " + run.skill;
  if (run.environment != problem.environment) return "the run is one in environment " + run.environment;
  if (run.actors.size() != problem.threads.size() + problem.devices.size()) return "other threads or devices";
  for (std::size_t t = 0; t < run.actors.size(); ++t) {
    const bool device = t >= problem.threads.size();
    const std::string& name =
        device ? problem.devices[t - problem.threads.size()].name : problem.threads[t].name;
    if (run.actors[t].name != name || run.actors[t].device != device)
      return "another actor " + run.actors[t].name;
  }
  if (run.statements.size() != problem.statements.size()) return "other statements";
  for (std::size_t s = 0; s < run.statements.size(); ++s) {
    const bool same = run.statements[s].module == problem.statements[s].module &&
                      run.statements[s].text == problem.statements[s].text;
    if (!same) return "another statement " + run.statements[s].text;
  }
  if (run.channels.size() != problem.channels.size()) return "other channels";
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    if (run.channels[c].message != problem.channels[c].message)
      return "another channel " + run.channels[c].message;
  }
  if (run.conditions != problem.conditions) return "other conditions";
  return {};
}

bool within(int index, std::size_t size) {
  return index >= -1 && index < static_cast<int>(size);
}

/// Whether an event of this kind is always one of a certain message or condition.
bool needs_subject(trace::Kind kind) {
  using Kind = trace::Kind;
  return kind == Kind::set || kind == Kind::read || kind == Kind::put || kind == Kind::take ||
         kind == Kind::drop || kind == Kind::overrun;
}

bool sound(const trace::Trace& run) {
  for (const trace::Event& event : run.events) {
    const bool conditions = event.kind == trace::Kind::set || event.kind == trace::Kind::read;
    const bool names = within(event.actor, run.actors.size()) &&
                       within(event.statement, run.statements.size()) &&
                       within(event.subject, conditions ? run.conditions.size() : run.channels.size());
    if (!names || (needs_subject(event.kind) && event.subject < 0)) return false;
  }
  return true;
}

}  // namespace

Ruling check_run(const Problem& problem, const Requirement* requirement, const trace::Trace& run,
                 std::optional<Nanoseconds> until) {
  Ruling ruling;
  ruling.broken = tables_differ(problem, run);
  if (ruling.broken.empty() && !sound(run)) ruling.broken = "an event names what is in no table";
  if (!ruling.broken.empty()) return ruling;
  Referee referee(problem, requirement, run.events);
  try {
    referee.follow(until);
  } catch (const Broken& rule) {
    ruling.broken = "at " + std::to_string(referee.now()) + " ns: " + rule.what();
  }
  ruling.measured = referee.gauge().measured();
  ruling.failed = referee.gauge().failed();
  using Measure = Requirement::Measure;
  const bool passes = requirement != nullptr && (requirement->measure == Measure::reaction ||
                                                 requirement->measure == Measure::interval);
  if (!passes || referee.may_come(requirement->at)) ruling.growing_since = referee.gauge().growing_since();
  return ruling;
}

}  // namespace pal::analyzer::rules
