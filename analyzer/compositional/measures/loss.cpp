// How many messages of devices no thread takes.
#include <algorithm>

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/measures/reasons.hpp"

namespace pal::analyzer::compositional {
namespace {

/// Why an answer to a request may get lost; empty: none may.
std::string answers_lost(const View& view, int request, std::vector<bool>& sends) {
  const Problem& problem = view.problem;
  if (may_give_up(problem, request)) return "somebody may give up waiting for an answer";
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    const Step& step = problem.steps[s];
    const int owner = view.forest.segments.owner(static_cast<int>(s));
    if (owner < 0 || step.kind != Step::Kind::send || step.channels.front() != request) continue;
    if (view.behaviours.threads[static_cast<std::size_t>(owner)].may_be_cancelled)
      return "a block that waits for an answer may be cancelled";
    sends[s] = true;
  }
  return "";
}

/// A request is served by the frame that starts within a period of it. So between two frames that serve a
/// request there are at most as many as start between two requests.
Bound frames_lost(const View& view, const Requirement& requirement, const pan::FrameDevice& frames,
                  const std::vector<bool>& sends) {
  const std::set<int> threads = owners(view, sends);
  std::string why = "nobody asks for frames for ever";
  const bool endless = std::any_of(threads.begin(), threads.end(), [&](int thread) {
    if (view.behaviours.threads[static_cast<std::size_t>(thread)].leaves) return false;
    const StatementOccurrences asks(view, thread, sends);
    const bool on = view.lasts(thread) && goes_on(view, thread);
    const bool asks_on = on && asks.in_every_job() && !asks.in_jobs().empty();
    if (!asks_on) why = why_not_again(view, thread, asks, on, "its request for a frame");
    return asks_on;
  });
  if (!endless || view.steady) return {Sum::unbounded(), why};
  const Bound distance = pause_bound(view, sends);
  if (!distance.known()) return distance;
  const Nanoseconds lost = distance.sum.value() / frames.period.count();
  return {Sum::number(requirement.in - requirement.in / (lost + 1)), ""};
}

}  // namespace

Bound loss_bound(const View& view, const Requirement& requirement) {
  const Device& device = view.problem.devices[static_cast<std::size_t>(requirement.device)];
  if (std::holds_alternative<pan::EventDevice>(device.behaviour)) return event_loss_bound(view, requirement);
  std::vector<bool> sends(view.problem.steps.size());
  for (int request : device.requests) {
    const std::string why = answers_lost(view, request, sends);
    if (!why.empty()) return {Sum::unbounded(), why};
  }
  if (const auto* frames = std::get_if<pan::FrameDevice>(&device.behaviour))
    return frames_lost(view, requirement, *frames, sends);
  return {Sum(), ""};
}

}  // namespace pal::analyzer::compositional
