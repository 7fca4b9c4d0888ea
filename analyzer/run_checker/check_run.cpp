#include "analyzer/run_checker/check_run.hpp"

#include "analyzer/run_checker/referee.hpp"

namespace pal::analyzer::run_checker {
namespace {

/// Whether the tables of the run are those of the problem; the first difference, or nothing.
std::string tables_differ(const Problem& problem, const trace::Trace& run) {
  if (run.skill != problem.skill) return "the run is one of skill " + run.skill;
  if (run.environment != problem.environment) return "the run is one in environment " + run.environment;
  if (run.actors.size() != problem.threads.size() + problem.devices.size()) return "other threads or devices";
  for (std::size_t a = 0; a < run.actors.size(); ++a) {
    const trace::Actor& said = run.actors[a];
    const ThreadId t(a);
    const bool device = !problem.threads.contains(t);
    const std::string& name =
        device ? problem.devices[DeviceId(a - problem.threads.size())].name : problem.threads[t].name;
    if (said.name != name || said.device != device) return "another actor " + said.name;
    if (device) continue;
    const Thread& thread = problem.threads[t];
    const std::string& processor = problem.processors[thread.processor].name;
    if (said.processor != processor || said.priority != thread.priority ||
        ThreadId::of(said.parent) != thread.parent)
      return name + " has another place, priority or parent";
  }
  if (run.statements.size() != problem.statements.size()) return "other statements";
  for (const StatementId s : problem.statements.ids()) {
    const trace::Statement& said = run.statements[s.index()];
    const bool same = said.module == problem.statements[s].module && said.text == problem.statements[s].text;
    if (!same) return "another statement " + said.text;
  }
  if (run.channels.size() != problem.channels.size()) return "other channels";
  for (const ChannelId c : problem.channels.ids()) {
    const trace::Channel& of = run.channels[c.index()];

    const bool same = of.message == problem.channels[c].message && of.sender == sender_name(problem, c) &&
                      of.receiver == receiver_name(problem, c);
    if (!same) return "another channel " + of.sender + " " + of.message + " " + of.receiver;
  }
  if (!std::equal(run.conditions.begin(), run.conditions.end(), problem.conditions.begin(),
                  problem.conditions.end()))
    return "other conditions";
  return {};
}

bool within(int index, std::size_t size) {
  return index >= -1 && index < static_cast<int>(size);
}

/// Whether each event names what it must, and says of it what can be; what is wrong, or nothing.
std::string unsound(const trace::Trace& run) {
  using Kind = trace::Kind;
  for (const trace::Event& event : run.events) {
    const bool condition = event.kind == Kind::set || event.kind == Kind::read;
    const bool message = event.kind == Kind::put || event.kind == Kind::take || event.kind == Kind::drop ||
                         event.kind == Kind::overrun;
    const bool names = within(event.actor, run.actors.size()) &&
                       within(event.statement, run.statements.size()) &&
                       within(event.subject, condition ? run.conditions.size() : run.channels.size());
    if (!names || ((condition || message) && event.subject < 0)) return "an event names what is in no table";
    if (condition && event.value != 0 && event.value != 1)
      return "a condition has another value than 0 and 1";
    if (event.time_ns < 0 || event.time_ns > latest_instant) return "an event is at no instant of a run";
  }
  return {};
}

/// Whether the messages of each channel are numbered in their order, and each is taken under its number.
std::string misnumbered(const trace::Trace& run) {
  using Kind = trace::Kind;
  std::vector<std::int64_t> newest(run.channels.size(),
                                   -1);  // by channel: the number of the last that was put
  for (const trace::Event& event : run.events) {
    const bool taken = event.kind == Kind::take || (event.kind == Kind::drop && event.actor < 0);
    if (event.kind != Kind::put && !taken) continue;
    std::int64_t& last = newest[static_cast<std::size_t>(event.subject)];
    if (taken ? event.value != last : event.value <= last) return "a message has the number of another";
    last = event.value;
  }
  return {};
}

}  // namespace

Ruling check_run(const Problem& problem, const Requirement* requirement, const trace::Trace& run,
                 std::optional<Nanoseconds> until, BusyFrom busy_from, const std::function<bool()>& stop) {
  Ruling ruling;
  ruling.broken = tables_differ(problem, run);
  if (ruling.broken.empty()) ruling.broken = unsound(run);
  if (ruling.broken.empty()) ruling.broken = misnumbered(run);
  if (ruling.broken.empty() && until && (*until < 0 || *until > latest_instant))
    ruling.broken = "it ends at no instant of a run";
  if (!ruling.broken.empty()) return ruling;
  Referee referee(problem, requirement, run.events, busy_from);
  try {
    ruling.stopped = !referee.follow(until, stop);
  } catch (const Broken& rule) {
    ruling.broken = "at " + std::to_string(referee.now()) + " ns: " + rule.what();
  }
  ruling.measured = referee.monitor().measured();
  ruling.failed = referee.monitor().failed();
  using Measure = Requirement::Measure;
  const bool passes = requirement != nullptr && (requirement->measure == Measure::reaction ||
                                                 requirement->measure == Measure::interval);
  if (!passes || referee.may_come(requirement->at)) ruling.growing_since = referee.monitor().growing_since();
  return ruling;
}

}  // namespace pal::analyzer::run_checker
