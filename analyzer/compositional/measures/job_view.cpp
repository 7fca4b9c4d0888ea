#include "analyzer/compositional/measures/job_view.hpp"

#include <algorithm>

#include "analyzer/compositional/causes/job_distance.hpp"

namespace pal::analyzer::compositional {

bool in_job(const View& view, NodeId node) {
  return in_job(view.forest, view.behaviours, node);
}

bool starts_in_jobs(const View& view, ThreadId thread) {
  const ThreadBehaviour& of = view.behaviours.threads[thread];
  const Thread& block = view.problem.threads[thread];
  return block.parent.valid() && !of.idle_wait.valid() && !of.nodes.empty() &&
         std::all_of(of.nodes.begin(), of.nodes.end(), [&](NodeId n) {
           const Node& node = view.forest.nodes[n];
           return view.forest.sources[node.source].period < never;
         });
}

bool goes_on(const View& view, ThreadId thread) {
  const ThreadId t = thread;
  if (view.reliable[t]) return view.begun[t];
  // What cannot end may be stopped in each job, before it has done anything.
  return view.lively[t] && view.problem.threads[t].can_end && starts_in_jobs(view, thread) &&
         goes_on(view, view.problem.threads[t].parent);
}

SourceId recurring_source(const View& view, ThreadId thread) {
  const ThreadBehaviour& of = view.behaviours.threads[thread];
  SourceId source{};
  for (NodeId n : starts_in_jobs(view, thread) ? of.nodes : of.job_starts) {
    const SourceId from = view.forest.nodes[n].source;
    if (view.forest.sources[from].period == never) continue;
    if (source.valid() && source != from) return SourceId{};
    source = from;
  }
  return source;
}

bool in_recurring_job(const View& view, NodeId node) {
  const ThreadId thread = view.forest.thread_of(node);
  const SourceId source = view.forest.nodes[node].source;
  return (in_job(view, node) || starts_in_jobs(view, thread)) && source == recurring_source(view, thread);
}

bool regular(const View& view, ThreadId thread) {
  const ThreadBehaviour& of = view.behaviours.threads[thread];
  const SourceId recurring = recurring_source(view, thread);
  if (!recurring.valid()) return false;
  const Source& source = view.forest.sources[recurring];
  const bool itself = std::any_of(of.job_starts.begin(), of.job_starts.end(), [&](NodeId n) {
    const Node& node = view.forest.nodes[n];
    return node.source == recurring && !node.cause.valid();
  });
  if (source.kind == Source::Kind::loop && itself) return true;
  Table<StepId, bool> at(view.problem.steps.size());
  at[of.idle_wait.valid() ? of.idle_wait : fork_of(view.problem, thread)] = true;
  if (source.kind == Source::Kind::loop) return source.roots.size() == 1 && always_comes(view, recurring, at);
  if (source.kind != Source::Kind::event) return false;
  Requirement comes;
  comes.measure = Requirement::Measure::response;
  comes.device = source.device;
  comes.at = std::move(at);
  return response_bound(view, comes).known();
}

bool in_order(const View& view, ThreadId thread) {
  const auto& job_starts = view.behaviours.threads[thread].job_starts;
  return std::count_if(job_starts.begin(), job_starts.end(),
                       [&](NodeId n) { return in_recurring_job(view, n); }) <= 1;
}

std::vector<NodeId> nodes_with(const View& view, StepId step) {
  std::vector<NodeId> found;
  const ThreadId owner = view.forest.segments.owner(step);
  for (NodeId n : view.behaviours.threads[owner].nodes) {
    for (const Segment::Passed& passed : view.forest.segment_of(view.forest.nodes[n]).steps) {
      if (passed.step == step) found.push_back(n);
    }
  }
  return found;
}

std::set<ThreadId> owners(const View& view, const Table<StepId, bool>& at) {
  std::set<ThreadId> found;
  for (const StepId s : at.ids()) {
    const ThreadId owner = view.forest.segments.owner(s);
    if (at[s] && owner.valid()) found.insert(owner);
  }
  return found;
}

}  // namespace pal::analyzer::compositional
