#include "analyzer/compositional/measures/statement_occurrences.hpp"

#include <algorithm>

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/causes/job_distance.hpp"
#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;

/// Steps from which one of `at` may come in the same thread.
Table<StepId, bool> reaching(const Problem& problem, const Table<StepId, bool>& at) {
  Table<StepId, bool> found = at;
  found.resize(problem.steps.size());
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = problem.steps.size(); i-- > 0;) {
      const StepId s(i);
      if (found[s]) continue;
      const auto& next = problem.steps[s].next;
      found[s] = std::any_of(next.begin(), next.end(), [&](StepId after) { return found[after]; });
      changed = changed || found[s];
    }
  }
  return found;
}

}  // namespace

StatementOccurrences::StatementOccurrences(const View& view, ThreadId thread, const Table<StepId, bool>& at)
    : view_(view),
      thread_(thread),
      at_(at),
      reachable_(reaching(view.problem, at)),
      begins_again_(recurrent(view.problem, {Beginning::Kind::entry, thread, {}, -1})) {
  const ThreadBehaviour& of = view.behaviours.threads[thread];
  for (NodeId n : of.nodes) {
    for (const Segment::Passed& passed : view.forest.segment_of(view.forest.nodes[n]).steps) {
      if (!at[passed.step]) continue;
      (in_recurring_job(view, n) ? in_jobs_ : before_jobs_).push_back({n, passed.step});
    }
  }
  const SourceId source = recurring_source(view, thread);
  if (!source.valid() || !regular(view, thread)) return;
  gap_ = compositional::gap(view, source);
  first_ = compositional::first(view, source);
  Way job;
  for (NodeId n : of.nodes) {
    const bool begins = view.behaviours.job_start[n] == n;
    if (begins && in_recurring_job(view, n)) merge(job, begun(n));
  }
  in_every_job_ = !job.ends_job && !job.lost;
  may_skip_ = job.ends_job;
  latest_ = job.latest;
  released_ = job.released;
  find_ends(source);
}

void StatementOccurrences::find_ends(SourceId source) {
  const AnalysisContext context{view_.problem, view_.forest, view_.behaviours};
  const auto latest_of = [&](Sum& ended, const std::vector<NodeId>& endings) {
    for (NodeId n : endings) ended = greater(ended, finish(view_, n));
  };
  latest_of(ended_, view_.behaviours.endings[source]);
  latest_of(ended_at_start_, context.endings_before_idle(thread_));
  latest_of(ended_at_start_, context.endings_before_first(source));
}

Sum StatementOccurrences::next_or_end(const Sum& effect) const {
  return gap_ + greater(effect, ended_);
}

Sum StatementOccurrences::first_or_end(const Sum& effect) const {
  return greater(first_ + greater(effect, ended_), ended_at_start_);
}

void StatementOccurrences::merge(Way& into, const Way& other) const {
  into.latest = greater(into.latest, other.latest);
  into.released = greater(into.released, other.released);
  into.ends_job = into.ends_job || other.ends_job;
  into.lost = into.lost || other.lost || !other.latest.bounded();
}

std::optional<StepId> StatementOccurrences::opening(NodeId node) const {
  const Beginning& begins = view_.forest.segment_of(view_.forest.nodes[node]).beginning;
  if (begins.kind == Beginning::Kind::entry) return view_.problem.threads[begins.thread].entry;
  const Step& step = view_.problem.steps[begins.step];
  if (begins.kind == Beginning::Kind::joined) return step.next.front();
  if (at_[begins.step]) return std::nullopt;
  const bool gives_up = begins.kind == Beginning::Kind::give_up;
  return gives_up ? step.next.back() : step.next[static_cast<std::size_t>(begins.arm)];
}

Way StatementOccurrences::begun(NodeId node) {
  const std::optional<StepId> first = opening(node);
  if (first) return from(node, *first);
  const StepId wait = view_.forest.segment_of(view_.forest.nodes[node]).beginning.step;
  return {compositional::latest(view_, node, wait), release(view_, node), false, false};
}

Way StatementOccurrences::from_entry() {
  Way way;
  bool any = false;
  for (NodeId n : view_.behaviours.threads[thread_].nodes) {
    if (view_.forest.segment_of(view_.forest.nodes[n]).beginning.kind == Beginning::Kind::entry) {
      any = true;
      merge(way, begun(n));
    }
  }
  way.lost = way.lost || !any;
  return way;
}

Way StatementOccurrences::after(StepEffect effect) {
  Way way;
  const Beginning& begins = view_.forest.segment_of(view_.forest.nodes[effect.node]).beginning;
  const Step& step = view_.problem.steps[effect.step];
  if (step.kind == Kind::wait) {
    const bool gives_up = begins.kind == Beginning::Kind::give_up;
    return from(effect.node, gives_up ? step.next.back() : step.next[static_cast<std::size_t>(begins.arm)]);
  }
  if (step.next.empty()) way = {finish(view_, effect.node), release(view_, effect.node), false, false};
  for (StepId next : step.next) merge(way, from(effect.node, next));
  return way;
}

Way StatementOccurrences::from(NodeId node, StepId at) {
  const auto leads_on = [&](StepId step) {
    const Kind kind = view_.problem.steps[step].kind;
    const bool ends = kind == Kind::wait || kind == Kind::fork || !reachable_[step];
    return !ends && !at_[step] && !known_.contains({node, step});
  };
  backwards(view_.problem, at, leads_on, [&](StepId step) {
    const auto [place, fresh] = known_.emplace(std::pair{node, step}, Way{Sum(), Sum(), false, true});
    if (fresh) place->second = way_from(node, step);
  });
  return known_.at({node, at});
}

Way StatementOccurrences::way_from(NodeId node, StepId at) {
  const Step& step = view_.problem.steps[at];
  Way way;
  if (!reachable_[at]) {
    if (begins_again_) {
      way.ends_job = true;
    } else {
      way = {finish(view_, node), release(view_, node), false, false};
    }
  } else if (step.kind == Kind::wait || step.kind == Kind::fork) {
    way = beyond_wait(node, at);
  } else if (at_[at]) {
    way = {compositional::latest(view_, node, at), release(view_, node), false, false};
  } else {
    // The skill may end.
    if (may_match_nothing(step)) way = {finish(view_, node), release(view_, node), false, false};
    for (StepId next : step.next) {
      const auto after = known_.find({node, next});
      merge(way, after == known_.end() ? Way{Sum(), Sum(), false, true} : after->second);
    }
  }
  way.lost = way.lost || !way.latest.bounded();
  return way;
}

/// What the thread does when its wait, or its blocks, are over.
Way StatementOccurrences::beyond_wait(NodeId node, StepId wait) {
  const ThreadBehaviour& of = view_.behaviours.threads[thread_];
  if (wait == of.idle_wait) return {Sum(), Sum(), true, false};
  Way way;
  bool any = false;
  for (NodeId other : of.nodes) {
    const Beginning& begins = view_.forest.segment_of(view_.forest.nodes[other]).beginning;
    const auto& previous = view_.behaviours.previous[other];
    if (begins.step != wait || std::find(previous.begin(), previous.end(), node) == previous.end()) continue;
    any = true;
    merge(way, begun(other));
  }
  way.lost = way.lost || !any;
  return way;
}

}  // namespace pal::analyzer::compositional
