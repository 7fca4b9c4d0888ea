// How many messages of devices no thread takes.
#include <algorithm>

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/measures/reasons.hpp"

namespace pal::analyzer::compositional {
namespace {

/// Why an answer to a request may get lost; empty: none may.
std::string answers_lost(const View& view, ChannelId request) {
  const Problem& problem = view.problem;
  if (may_give_up(problem, request)) return "a thread may give up waiting for an answer";
  for (const StepId s : problem.steps.ids()) {
    const Step& step = problem.steps[s];
    const ThreadId owner = view.forest.segments.owner(s);
    if (!owner.valid() || step.kind != Step::Kind::send || step.channels.front() != request) continue;
    if (view.behaviours.threads[owner].may_be_cancelled)
      return "a block that waits for an answer may be cancelled";
  }
  return "";
}

}  // namespace

Bound loss_bound(const View& view, const Requirement& requirement) {
  const Device& device = view.problem.devices[requirement.device];
  if (std::holds_alternative<pan::EventDevice>(device.behaviour)) return event_loss_bound(view, requirement);
  if (std::holds_alternative<pan::FrameDevice>(device.behaviour))
    return {Sum::unbounded(), "how many frames start while no request for one waits is open"};
  for (ChannelId request : device.requests) {
    const std::string why = answers_lost(view, request);
    if (!why.empty()) return {Sum::unbounded(), why};
  }
  return {Sum(), ""};
}

}  // namespace pal::analyzer::compositional
