// Greatest and least interval between effects of statements.
#include <algorithm>
#include <utility>

#include "analyzer/compositional/causes/job_distance.hpp"
#include "analyzer/compositional/measures/reasons.hpp"

namespace pal::analyzer::compositional {
namespace {

/// From an effect to the next, in the one thread that comes to it.
Bound greatest_interval(const View& view, const Table<StepId, bool>& at) {
  const std::set<ThreadId> threads = owners(view, at);
  if (Why found = why_not_one(view, threads); !found.empty()) return no_bound(std::move(found));
  const ThreadId thread = *threads.begin();
  const ThreadId t = thread;
  StatementOccurrences occurrences(view, thread, at);
  const ThreadBehaviour& of = view.behaviours.threads[t];
  const bool has_jobs = of.idle_wait.valid() || starts_in_jobs(view, thread);
  const bool stops = has_jobs && !view.reliable[t] && !goes_on(view, thread);
  const Bound none = no_bound(why_not_again(view, thread, occurrences, !stops));
  // What has had an effect has begun.
  if (view.forest.withholds(none.why) && (has_jobs ? stops : !view.lively[t])) return none;
  Sum end;
  for (NodeId n : of.nodes) {
    if (in_recurring_job(view, n)) end = greater(end, finish(view, n));
  }
  const auto follow = [&](StepEffect effect, const Sum& distance) {
    const Way way = occurrences.after(effect);
    const bool skips = way.ends_job && !occurrences.in_every_job();
    if (way.lost || (skips && view.forest.withholds(none.why))) return Sum::unbounded();
    Sum next = way.latest;
    if (way.ends_job) next = greater(next, distance + occurrences.latest());
    // What a cancelled block has begun it finishes.
    if (of.may_be_cancelled) next = greater(next, end);
    return next - earliest(view, effect.node, effect.step);
  };
  Sum longest;
  for (const StepEffect& effect : occurrences.in_jobs())
    longest = greater(longest, follow(effect, occurrences.gap()));
  for (const StepEffect& effect : occurrences.before_jobs())
    longest = greater(longest, follow(effect, occurrences.first()));
  return {longest, none.why};
}

/// If each occurrence of one source brings one effect at most: from the latest in one job to the earliest
/// in the next.
Sum least_by_source(const View& view, const std::vector<StepEffect>& all) {
  if (all.empty()) return {};
  const SourceId source = view.forest.nodes[all.front().node].source;
  const Source& of = view.forest.sources[source];
  if (of.period >= never) return {};
  Sum sooner = Sum::unbounded();
  Sum later;
  if (!are_exclusive({view.problem, view.forest, view.behaviours}, all)) return {};
  for (const StepEffect& effect : all) {
    sooner = less(sooner, earliest(view, effect.node, effect.step));
    later = greater(later, latest(view, effect.node, effect.step));
  }
  if (!later.bounded()) return {};
  return greater(
      Sum(), Sum(of.period, {Term::Kind::said, {}, {}, source, "comes no sooner again"}) + sooner - later);
}

/// What the shortest way through the program takes.
Sum by_the_way(const View& view, const Table<StepId, bool>& at, ThreadId thread) {
  return {least_effect_distance(view.problem, thread, at),
          {Term::Kind::said, {}, {}, {}, "what lies on the shortest way from one to the next"}};
}

Bound least_interval(const View& view, const Requirement& requirement) {
  const Sum least = least_distance(view, requirement.at);
  if (!least.bounded()) return no_bound(why(Withheld::comes_once));
  if (least.value() == 0) return no_bound(why(Withheld::nothing_separates));
  return {least};
}

}  // namespace

Sum least_distance(const View& view, const Table<StepId, bool>& at) {
  const std::set<ThreadId> threads = owners(view, at);
  if (threads.size() != 1) return {};
  std::vector<StepEffect> all;
  for (const StepId s : at.ids()) {
    if (!at[s] || !view.forest.segments.owner(s).valid()) continue;
    for (NodeId n : nodes_with(view, s)) all.push_back({n, s});
  }
  return greater(least_by_source(view, all), by_the_way(view, at, *threads.begin()));
}

Bound interval_bound(const View& view, const Requirement& requirement) {
  return requirement.at_least ? least_interval(view, requirement) : greatest_interval(view, requirement.at);
}

}  // namespace pal::analyzer::compositional
