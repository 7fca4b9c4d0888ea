// Samples and reactions: how old what a thread knows can be where it is used, and until something newer is.
#include <algorithm>
#include <utility>

#include "analyzer/compositional/measures/data_freshness.hpp"
#include "analyzer/compositional/measures/reasons.hpp"

namespace pal::analyzer::compositional {
namespace {

Sum since_known(const DataFreshness& freshness, StepEffect effect, const Sum& until) {
  const DataFreshness::Known known = freshness.at(effect);
  return known ? until - known->at : Sum::unbounded();
}

bool of_start(const View& view, NodeId node) {
  const SourceId source = view.forest.nodes[node].source;
  return view.forest.sources[source].kind == Source::Kind::start;
}

}  // namespace

Bound known_age_bound(const View& view, const Requirement& requirement) {
  const DataFreshness freshness(view, requirement);
  Sum oldest;
  Why unknown;
  for (const StepId s : view.problem.steps.ids()) {
    if (!requirement.at[s] || !view.forest.segments.owner(s).valid()) continue;
    for (NodeId n : nodes_with(view, s)) {
      const StepEffect effect{n, s};
      const Sum age = since_known(freshness, effect, latest(view, n, effect.step));
      oldest = greater(oldest, less(age, freshness.age_since_cause(effect)));
      if (!oldest.bounded() && unknown.empty())
        unknown = freshness.with_reason(why(Withheld::sample_unknown), view.forest.thread_of(n));
    }
  }
  return {oldest, unknown};
}

/// From what one effect reflects to the next effect, in the one thread that comes to it.
Bound reaction_bound(const View& view, const Requirement& requirement) {
  const std::set<ThreadId> threads = owners(view, requirement.at);
  if (Why found = why_not_one(view, threads); !found.empty()) return no_bound(std::move(found));
  const ThreadId thread = *threads.begin();
  const ThreadId t = thread;
  const std::string& name = view.problem.threads[t].name;
  StatementOccurrences occurrences(view, thread, requirement.at);
  if (occurrences.in_jobs().empty()) return no_bound(why(Withheld::not_known_when, name, "it"));
  if (!goes_on(view, thread) || !occurrences.in_every_job()) {
    Why found = why_not_again(view, thread, occurrences, goes_on(view, thread));
    if (view.forest.withholds(found)) return no_bound(std::move(found));
  }
  const auto before = [&](const Way& way, const Sum& job) {
    return way.lost ? Sum::unbounded() : greater(way.latest, job);
  };
  const DataFreshness freshness(view, requirement);
  const Sum first = occurrences.first() + occurrences.latest();
  const Sum next = occurrences.gap() + occurrences.latest();
  // The first may come on a path that never returns to the idle wait, and so may the next after any. What is
  // known before the jobs is no older than the skill.
  Sum longest = before(occurrences.from_entry(), first);
  for (const StepEffect& effect : occurrences.before_jobs()) {
    const Sum until = before(occurrences.after(effect), Sum());
    longest = greater(longest, of_start(view, effect.node) ? until : since_known(freshness, effect, until));
  }
  Sum end;
  for (NodeId n : view.behaviours.threads[t].nodes) {
    if (in_recurring_job(view, n)) end = greater(end, finish(view, n));
  }
  for (const StepEffect& effect : occurrences.in_jobs()) {
    longest = greater(longest, since_known(freshness, effect, before(occurrences.after(effect), next)));
    // A statement that a cancelled block finishes.
    if (view.behaviours.threads[t].may_be_cancelled)
      longest = greater(longest, since_known(freshness, effect, end));
  }
  return {longest, freshness.with_reason(why(Withheld::knowledge_unknown, name), thread)};
}

}  // namespace pal::analyzer::compositional
