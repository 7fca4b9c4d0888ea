// What is required of a problem.
#include <algorithm>

#include "analyzer/problem/problem_builder.hpp"
#include "pal/support/finding.hpp"

namespace pal::analyzer {

using namespace pan;

Table<StepId, bool> ProblemBuilder::steps_at(const std::vector<StatementRef>& at,
                                             const pan::Requirement& requirement) {
  Table<StepId, bool> steps(problem_.steps.size());
  if (steps_of_.empty()) {
    for (const StepId s : problem_.steps.ids()) {
      const StatementId statement = problem_.steps[s].statement;
      if (!statement.valid()) continue;
      const Statement& known = problem_.statements[statement];
      steps_of_[{known.source_module, known.source_node}].push_back(s);
    }
  }
  bool any = false;
  for (const StatementRef& ref : at) {
    const auto found = steps_of_.find({ref.module, ref.node});
    if (found == steps_of_.end()) continue;
    for (const StepId s : found->second) steps[s] = any = true;
  }
  if (!any) {
    diagnostics_.report(Finding::requirement_at_unreachable, requirement.where, requirement.name);
  }
  return steps;
}

/// The steps of loops, and of what is executed in them.
Table<StepId, bool> ProblemBuilder::steps_in(const std::vector<StatementRef>& loops) const {
  const auto is_meant = [&](LoopId l) {
    const ProgramLoop& known = problem_.loops[l];
    return std::any_of(loops.begin(), loops.end(), [&known](const StatementRef& loop) {
      return loop.module == known.module && loop.node == known.repeat;
    });
  };
  Table<StepId, bool> steps(problem_.steps.size());
  for (const LoopId l : problem_.loops.ids()) {
    if (!is_meant(l)) continue;
    for (const StepId s : steps.ids()) steps[s] = steps[s] || is_in(problem_, s, l);
  }
  return steps;
}

void ProblemBuilder::requirements() {
  for (const pan::Requirement& requirement : network_.requirements) {
    Requirement made;
    made.name = requirement.name;
    made.limit = requirement.limit.count();
    made.where = requirement.where;
    if (requirement.phase) made.phase.text = requirement.phase->text;
    if (requirement.phase && !requirement.phase->after.empty())
      made.phase.after = steps_at(requirement.phase->after, requirement);
    if (requirement.phase && !requirement.phase->during.empty())
      made.phase.during = steps_in(requirement.phase->during);
    std::visit([&](const auto& each) { measure(each, requirement, std::move(made)); }, requirement.measure);
  }
  for (std::size_t d = 0; d < problem_.devices.size(); ++d) demanded_answer(DeviceId(d));
}

void ProblemBuilder::require(Requirement made) {
  time(Duration(made.limit), made.where, "the limit of " + made.name);
  problem_.requirements.push_back(std::move(made));
}

void ProblemBuilder::measure(const Response& response, const pan::Requirement& requirement,
                             Requirement made) {
  made.measure = Requirement::Measure::response;
  for (const ChannelId channel : response.of) {
    made.events.push_back(channel);
    made.device = problem_.channels[channel].sender_device;
  }
  made.at = steps_at(response.at, requirement);
  require(std::move(made));
}

void ProblemBuilder::known(const Known& known, Requirement& made) {
  if (const auto* condition = std::get_if<ConditionId>(&known)) {
    made.condition = ConditionId(condition->index());
    return;
  }
  for (const ChannelId channel : std::get<std::vector<pan::ChannelId>>(known)) {
    made.samples.push_back(channel);
    made.device = problem_.channels[channel].sender_device;
  }
}

void ProblemBuilder::measure(const Age& age, const pan::Requirement& requirement, Requirement made) {
  made.measure = Requirement::Measure::age;
  known(age.of, made);
  made.at = steps_at(age.at, requirement);
  require(std::move(made));
}

void ProblemBuilder::measure(const Reaction& reaction, const pan::Requirement& requirement,
                             Requirement made) {
  made.measure = Requirement::Measure::reaction;
  known(reaction.of, made);
  made.at = steps_at(reaction.at, requirement);
  require(std::move(made));
}

/// A requirement with two limits is two: each has its own bound and its own run.
void ProblemBuilder::measure(const Passes& passes, const pan::Requirement& requirement, Requirement made) {
  made.measure = Requirement::Measure::interval;
  made.at = steps_at(passes.at, requirement);
  const bool both = passes.least && passes.most;
  if (passes.least) {
    Requirement least = made;
    least.at_least = true;
    least.limit = passes.least->count();
    if (both) least.name += ".least";
    require(std::move(least));
  }
  if (!passes.most) return;
  made.limit = passes.most->count();
  if (both) made.name += ".most";
  require(std::move(made));
}

void ProblemBuilder::measure(const Loss& loss, const pan::Requirement& requirement, Requirement made) {
  made.measure = Requirement::Measure::loss;
  made.device = device_of(network_, loss.of);
  made.limit = loss.most;
  made.in = loss.in;
  const Device& device = problem_.devices[made.device];
  if (!device.event.valid() && device.requests.empty()) {
    diagnostics_.report(Finding::nothing_to_lose, requirement.where, device.name);
  }
  require(std::move(made));
}

void ProblemBuilder::measure(const Completing& completing, const pan::Requirement&, Requirement made) {
  made.measure = Requirement::Measure::duration;
  made.code = completing.code;
  require(std::move(made));
}

std::vector<ProcessorId> ProblemBuilder::processors_named(const std::string& name,
                                                          const pan::Requirement& requirement) {
  std::vector<ProcessorId> found;
  for (const ProcessorId p : problem_.processors.ids()) {
    if (name.empty() || name == problem_.processors[p].name) found.push_back(p);
  }
  if (found.empty()) {
    diagnostics_.report(Finding::load_of_unknown_processor, requirement.where, environment_.name, name);
  }
  return found;
}

void ProblemBuilder::measure(const Load& load, const pan::Requirement& requirement, Requirement made) {
  made.measure = Requirement::Measure::load;
  made.processors = processors_named(load.processor, requirement);
  require(std::move(made));
}

void ProblemBuilder::measure(const BusyPeriod& busy, const pan::Requirement& requirement, Requirement made) {
  made.measure = Requirement::Measure::busy;
  made.processors = processors_named(busy.processor, requirement);
  require(std::move(made));
}

/// What an event device demands of the thread that takes its events is a requirement like the skill's own.
void ProblemBuilder::demanded_answer(DeviceId d) {
  const Device& device = problem_.devices[d];
  const auto* event = std::get_if<EventDevice>(&device.behaviour);
  if (event == nullptr || event->answer.empty() || !device.event.valid()) return;
  SourceSpan where;
  for (const DeviceTiming& timing : environment_.devices) {
    if (timing.device == device.name) where = timing.where;
  }
  Requirement made;
  made.name = device.name + ".answer";
  made.measure = Requirement::Measure::response;
  made.events = {device.event};
  made.device = d;
  made.where = where;
  made.at.assign(problem_.steps.size(), false);
  bool any = false;
  for (const StepId s : problem_.steps.ids()) {
    const Step& step = problem_.steps[s];
    if (step.kind != Step::Kind::send) continue;
    const Channel& channel = problem_.channels[step.channels.front()];
    if (channel.receiver_device == d && channel.message == event->answer) made.at[s] = any = true;
  }
  if (!any) {
    diagnostics_.report(Finding::nothing_sends_answer, where, network_.skill.name, event->answer,
                        device.name);
    return;
  }
  if (!event->answer_within) return;
  time(*event->answer_within, where, "an answer to " + device.name);
  made.limit = event->answer_within->count();
  problem_.requirements.push_back(std::move(made));
}

}  // namespace pal::analyzer
