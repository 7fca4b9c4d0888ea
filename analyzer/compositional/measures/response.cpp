// How long an event, or a message, waits for its answer.
#include <algorithm>
#include <utility>

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/measures/event_propagation.hpp"
#include "analyzer/compositional/measures/statement_occurrences.hpp"

namespace pal::analyzer::compositional {
namespace {

/// The source of a device's events; -1: no thread waits for them.
SourceId source_of(const View& view, DeviceId device) {
  for (const SourceId s : view.forest.sources.ids()) {
    const Source& of = view.forest.sources[s];
    if (of.kind == Source::Kind::event && of.device == device) return s;
  }
  return SourceId{};
}

/// Whether events cannot overtake one another although several are on their way. They cannot if every thread
/// that they meet serves them alone, in one job each, and if one thread answers.
bool in_order(const View& view, const Requirement& requirement, SourceId source) {
  std::set<ThreadId> answering;
  for (const NodeId i : view.forest.nodes.ids()) {
    if (view.forest.nodes[i].source != source) continue;
    const NodeId n = i;
    const ThreadId thread = view.forest.thread_of(n);
    if (view.behaviours.threads[thread].job_starts.size() != 1) return false;
    for (const Segment::Passed& passed : view.forest.segment_of(view.forest.nodes[i]).steps) {
      if (requirement.at[passed.step]) answering.insert(thread);
    }
  }
  return answering.size() == 1;
}

/// Why events of a source may find their slot full; empty: they do not.
Why overrun(const View& view, SourceId source) {
  if (view.times.no_overrun[source]) return {};
  const Source& of = view.forest.sources[source];
  for (NodeId root : of.roots) {
    const Why& unbounded_reason = view.times.unbounded_reason[view.forest.thread_of(root)];
    if (!unbounded_reason.empty()) return unbounded_reason;
  }
  if (!view.withholds(Withheld::event_overrun)) return {};
  return why(Withheld::event_overrun, view.problem.devices[of.device].name);
}

Bound to_event(const View& view, const Requirement& requirement, SourceId source) {
  const Source& of = view.forest.sources[source];
  if (of.roots.empty()) return no_bound(why(Withheld::no_event_taken, view.problem.devices[of.device].name));
  const NodeId root = of.roots.front();
  if (Why lost = overrun(view, source); !lost.empty()) return no_bound(std::move(lost));
  EventPropagation propagation(view, requirement.at, EventPropagation::Since::event);
  const Sum answer = propagation.node_value(root);
  if (!answer.bounded())
    return no_bound(propagation.why().empty() ? why(Withheld::event_unanswered) : propagation.why());
  const Nanoseconds distance = of.period - of.jitter;
  const bool overtakes = (answer.value() >= distance || view.steady) && !in_order(view, requirement, source);
  if (overtakes && view.withholds(Withheld::event_overtaken)) return no_bound(why(Withheld::event_overtaken));
  return {greater(Sum(), answer)};
}

/// Whether the statements are all the sends of the answer to one request, and each request follows the take
/// of the answer before. Of a request to several parties one may be made before another is answered.
bool answered_in_turn(const View& view, const Requirement& requirement) {
  if (requirement.events.size() != 1) return false;
  const ChannelId request = requirement.events.front();
  const ChannelId answer = view.problem.channels[request].answer;
  if (!answer.valid() || !view.problem.channels[answer].sender_module.valid()) return false;
  if (may_give_up(view.problem, request)) return false;
  const auto& steps = view.problem.steps;
  for (const StepId s : steps.ids()) {
    const bool answers = steps[s].kind == Step::Kind::send && steps[s].channels.front() == answer;
    if (answers && !requirement.at[s]) return false;
  }
  return true;
}

/// Each message is put at some instant of a job of its sender, and answered at another that the same source
/// brings about. It must be answered before the next one can be put.
Bound to_message(const View& view, const Requirement& requirement) {
  const Table<StepId, bool> sends = sends_of_events(view.problem, requirement);
  EventPropagation propagation(view, requirement.at, EventPropagation::Since::nominal);
  Sum longest;
  for (const StepId s : sends.ids()) {
    if (!sends[s]) continue;
    const StepId send = s;
    for (NodeId n : nodes_with(view, send)) {
      const SourceId source = view.forest.nodes[n].source;
      const bool event = view.forest.sources[source].kind == Source::Kind::event;
      if (Why lost = event ? overrun(view, source) : Why{}; !lost.empty()) return no_bound(std::move(lost));
      const Sum answered = propagation.sent_value(n, send);
      if (!answered.bounded())
        return no_bound(propagation.why().empty() ? why(Withheld::message_unanswered) : propagation.why());
      longest = greater(longest, answered - earliest(view, n, send));
    }
  }
  const bool overtakes =
      !answered_in_turn(view, requirement) && longest.value() >= least_distance(view, sends).value();
  if (overtakes && view.withholds(Withheld::message_overtaken))
    return no_bound(why(Withheld::message_overtaken));
  return {longest};
}

}  // namespace

Table<StepId, bool> sends_of_events(const Problem& problem, const Requirement& requirement) {
  Table<StepId, bool> sends(problem.steps.size());
  const bool by_device =
      std::all_of(requirement.events.begin(), requirement.events.end(),
                  [&problem](ChannelId channel) { return problem.channels[channel].sender_device.valid(); });
  if (by_device) return sends;  // no step sends them
  for (const StepId s : sends.ids()) {
    const Step& step = problem.steps[s];
    sends[s] = step.kind == Step::Kind::send && requirement.is_event(step.channels.front());
  }
  return sends;
}

Bound response_bound(const View& view, const Requirement& requirement) {
  if (!requirement.device.valid()) return to_message(view, requirement);
  const SourceId source = source_of(view, requirement.device);
  return source.valid() ? to_event(view, requirement, source) : no_bound(why(Withheld::response_to_answer));
}

bool always_comes(const View& view, SourceId source, const Table<StepId, bool>& at) {
  EventPropagation propagation(view, at, EventPropagation::Since::event);
  const auto& roots = view.forest.sources[source].roots;
  return std::any_of(roots.begin(), roots.end(),
                     [&](NodeId root) { return propagation.node_value(root).bounded(); });
}

Bound event_loss_bound(const View& view, const Requirement& requirement) {
  const SourceId source = source_of(view, requirement.device);
  const Why unawaited = why(Withheld::no_event_taken, view.problem.devices[requirement.device].name);
  if (!source.valid()) return no_bound(unawaited);
  const Source& of = view.forest.sources[source];
  if (of.roots.empty()) return no_bound(unawaited);
  if (Why lost = overrun(view, source); !lost.empty()) return no_bound(std::move(lost));
  EventPropagation propagation(view, requirement.at, EventPropagation::Since::event);
  return propagation.certain(of.roots.front()) ? Bound{Sum()} : no_bound(propagation.why());
}

}  // namespace pal::analyzer::compositional
