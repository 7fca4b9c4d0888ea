// How many messages of devices no thread takes.
#include <algorithm>
#include <utility>

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/measures/reasons.hpp"

namespace pal::analyzer::compositional {
namespace {

/// Why an answer to a request may get lost; empty: none may.
Why answers_lost(const View& view, ChannelId request) {
  const Problem& problem = view.problem;
  if (view.withholds(Withheld::answer_given_up) && may_give_up(problem, request))
    return why(Withheld::answer_given_up);
  if (!view.withholds(Withheld::asker_cancelled)) return {};
  for (const StepId s : problem.steps.ids()) {
    const Step& step = problem.steps[s];
    const ThreadId owner = view.forest.segments.owner(s);
    if (!owner.valid() || step.kind != Step::Kind::send || step.channels.front() != request) continue;
    if (view.behaviours.threads[owner].may_be_cancelled) return why(Withheld::asker_cancelled);
  }
  return {};
}

}  // namespace

Bound loss_bound(const View& view, const Requirement& requirement) {
  const Device& device = view.problem.devices[requirement.device];
  if (std::holds_alternative<pan::EventDevice>(device.behaviour)) return event_loss_bound(view, requirement);
  if (view.withholds(Withheld::frames_lost) && std::holds_alternative<pan::FrameDevice>(device.behaviour))
    return no_bound(why(Withheld::frames_lost));
  for (ChannelId request : device.requests) {
    if (Why lost = answers_lost(view, request); !lost.empty()) return no_bound(std::move(lost));
  }
  return {Sum()};
}

}  // namespace pal::analyzer::compositional
