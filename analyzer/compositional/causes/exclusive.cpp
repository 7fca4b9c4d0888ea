#include "analyzer/compositional/causes/exclusive.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {
namespace {

/// The wait that a job cannot pass without the next one having begun; -1: there is none. A thread that
/// gives up there goes on in the same job.
StepId end_of_job(const AnalysisContext& context, NodeId node) {
  const NodeId job_start = context.job_start_of(node);
  const Beginning& begins = context.segment(job_start).beginning;
  if (begins.kind != Beginning::Kind::arm || context.step_at(begins.step).within) return StepId{};
  return begins.step == context.behaviour_of(begins.thread).idle_wait ? begins.step : StepId{};
}

/// By node.
using Steps = std::map<NodeId, std::vector<StepId>>;
/// By step.
using Nodes = std::map<StepId, std::vector<NodeId>>;

/// Whether a run of one node passes two of its steps.
bool any_in_node(const AnalysisContext& context, const Steps& steps_of) {
  std::set<std::pair<SegmentId, std::vector<StepId>>> seen;  // segments and steps
  return std::any_of(steps_of.begin(), steps_of.end(), [&](const auto& of) {
    const SegmentId segment = context.node(of.first).segment;
    return seen.emplace(segment, of.second).second &&
           any_in_row(context.problem, context.segment(of.first), of.second);
  });
}

/// Whether a run of the job passes a step in one node and then one in another.
bool any_in_job(const AnalysisContext& context, const Nodes& nodes_of) {
  return std::any_of(nodes_of.begin(), nodes_of.end(), [&](const auto& before) {
    const auto& [first, nodes] = before;
    const StepId end = end_of_job(context, nodes.front());
    return follow(context.problem, context.step_at(first).next, [&](StepId at) {
      const auto second = nodes_of.find(at);
      const bool one_node = second != nodes_of.end() && nodes.size() == 1 && second->second == nodes;
      if (second != nodes_of.end() && !one_node) return Course::found;
      return at == end ? Course::ends : Course::goes_on;
    });
  });
}

}  // namespace

bool are_exclusive(const AnalysisContext& context, const std::vector<StepEffect>& occurrences) {
  Steps steps_of;
  Nodes nodes_of;
  for (const StepEffect& effect : occurrences) {
    if (context.job_start_of(effect.node) != context.job_start_of(occurrences.front().node)) return false;
    steps_of[effect.node].push_back(effect.step);
    nodes_of[effect.step].push_back(effect.node);
  }
  return !any_in_node(context, steps_of) && !any_in_job(context, nodes_of);
}

}  // namespace pal::analyzer::compositional
