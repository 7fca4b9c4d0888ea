#include "analyzer/compositional/causes/exclusive.hpp"

#include <map>
#include <tuple>

#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {
namespace {

/// The wait that a job cannot pass without the next one having begun; -1: there is none. Who gives up there
/// goes on in the same job.
int end_of_job(const AnalysisContext& context, int node) {
  const int job_start = context.job_start_of(node);
  const Beginning& begins = context.segment(job_start).beginning;
  if (begins.kind != Beginning::Kind::arm || context.step_at(begins.step).within) return -1;
  return begins.step == context.behaviour_of(begins.thread).idle_wait ? begins.step : -1;
}

/// Whether a job that has passed `first` may come to another step.
bool may_follow(const AnalysisContext& context, const StepEffect& first, int second) {
  const int end = end_of_job(context, first.node);
  return follow(context.problem, context.step_at(first.step).next, [&](int at) {
    if (at == second) return Course::found;
    return at == end ? Course::ends : Course::goes_on;
  });
}

using Places = std::map<int, std::vector<int>>;

/// Whether a run of one node passes two of its steps.
bool any_in_node(const AnalysisContext& context, const Places& steps_of) {
  std::map<std::tuple<int, int, int>, bool> known;  // by segment and steps
  for (const auto& [node, steps] : steps_of) {
    for (int first : steps) {
      for (int second : steps) {
        const auto [place, fresh] =
            known.emplace(std::tuple{context.node(node).segment, first, second}, false);
        if (fresh) place->second = comes_after(context.problem, context.segment(node), first, second);
        if (place->second) return true;
      }
    }
  }
  return false;
}

/// Whether a run of the job passes a step in one node and then one in another.
bool any_in_job(const AnalysisContext& context, const Places& nodes_of) {
  for (const auto& [first, nodes] : nodes_of) {
    for (const auto& [second, others] : nodes_of) {
      const bool one_node = nodes.size() == 1 && others == nodes;
      if (!one_node && may_follow(context, {nodes.front(), first}, second)) return true;
    }
  }
  return false;
}

}  // namespace

bool are_exclusive(const AnalysisContext& context, const std::vector<StepEffect>& occurrences) {
  Places steps_of;  // by node
  Places nodes_of;  // by step
  for (const StepEffect& effect : occurrences) {
    if (context.job_start_of(effect.node) != context.job_start_of(occurrences.front().node)) return false;
    steps_of[effect.node].push_back(effect.step);
    nodes_of[effect.step].push_back(effect.node);
  }
  return !any_in_node(context, steps_of) && !any_in_job(context, nodes_of);
}

}  // namespace pal::analyzer::compositional
