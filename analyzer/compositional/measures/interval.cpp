// Greatest and least interval between effects of statements.
#include <algorithm>

#include "analyzer/compositional/causes/job_distance.hpp"
#include "analyzer/compositional/measures/reasons.hpp"

namespace pal::analyzer::compositional {
namespace {

/// What counts besides the times from one effect of a thread to its next.
struct Besides {
  bool from_start = false;
  bool to_end = false;  // of the skill
};

/// From an effect in one thread to the next.
Bound greatest_in(const View& view, const std::vector<bool>& at, int thread, Besides besides) {
  const auto t = static_cast<std::size_t>(thread);
  StatementOccurrences occurrences(view, thread, at);
  const ThreadBehaviour& of = view.behaviours.threads[t];
  const bool has_jobs = of.idle_wait >= 0 || starts_in_jobs(view, thread);
  const bool stops = has_jobs && !view.reliable[t] && !goes_on(view, thread);
  const Bound none{Sum::unbounded(), why_not_again(view, thread, occurrences, !stops)};
  // What has had an effect has begun.
  if (has_jobs ? stops : !view.lively[t]) return none;
  Sum longest = besides.from_start ? occurrences.first_or_end(occurrences.latest()) : Sum();
  // Others may come to it when this thread does not any more.
  const bool always = occurrences.in_every_job() && !occurrences.in_jobs().empty() && goes_on(view, thread);
  if ((besides.from_start || besides.to_end) && !always) return none;
  Sum end;
  for (int n : of.nodes) {
    if (in_recurring_job(view, n)) end = greater(end, finish(view, n));
  }
  const auto follow = [&](StepEffect effect, const Sum& distance, const Sum& over) {
    const Way way = occurrences.after(effect);
    if (way.lost || (way.ends_job && !occurrences.in_every_job())) return Sum::unbounded();
    Sum next = way.latest;
    if (way.ends_job) next = greater(next, distance + occurrences.latest());
    if (besides.to_end) next = greater(next, over);
    // What a cancelled block has begun it finishes.
    if (of.may_be_cancelled) next = greater(next, end);
    return next - earliest(view, effect.node, effect.step);
  };
  const Sum next_or_end = occurrences.next_or_end(occurrences.latest());
  const Sum first_or_end = occurrences.first_or_end(occurrences.latest());
  for (const StepEffect& effect : occurrences.in_jobs())
    longest = greater(longest, follow(effect, occurrences.gap(), next_or_end));
  for (const StepEffect& effect : occurrences.before_jobs())
    longest = greater(longest, follow(effect, occurrences.first(), first_or_end));
  return {longest, none.why};
}

Bound greatest_interval(const View& view, const std::vector<bool>& at, bool to_end) {
  const std::set<int> threads = owners(view, at);
  Bound least{Sum::unbounded(), threads.empty() ? "no thread comes to it"
                                                : "none of the threads that come to it surely goes on"};
  for (int thread : threads) {
    const ThreadBehaviour& of = view.behaviours.threads[static_cast<std::size_t>(thread)];
    // One of several must go on for as long as any of them.
    if (threads.size() > 1 && (of.leaves || of.may_be_cancelled || !goes_on(view, thread))) continue;
    // The others may come to it until the skill has ended.
    const bool others = threads.size() > 1;
    const Bound bound = greatest_in(view, at, thread, {others, others || to_end});
    if (bound.sum.value() < least.sum.value() || !least.known()) least = bound;
  }
  return least;
}

/// If each occurrence of one source brings one effect at most: from the latest in one job to the earliest
/// in the next.
Sum least_by_source(const View& view, const std::vector<StepEffect>& all) {
  if (all.empty()) return {};
  const int source = view.forest.nodes[static_cast<std::size_t>(all.front().node)].source;
  const Source& of = view.forest.sources[static_cast<std::size_t>(source)];
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
      Sum(), Sum(of.period, {Term::Kind::said, -1, -1, source, "comes no sooner again"}) + sooner - later);
}

/// What the shortest way through the program takes.
Sum by_the_way(const View& view, const std::vector<bool>& at, int thread) {
  return {least_effect_distance(view.problem, thread, at),
          {Term::Kind::said, -1, -1, -1, "what lies on the shortest way from one to the next"}};
}

Bound least_interval(const View& view, const Requirement& requirement) {
  const Sum least = least_distance(view, requirement.at);
  if (!least.bounded()) return {Sum::unbounded(), "it comes once at most"};
  if (least.value() == 0) return {Sum::unbounded(), "nothing separates two occurrences"};
  return {least, ""};
}

}  // namespace

Sum least_distance(const View& view, const std::vector<bool>& at) {
  const std::set<int> threads = owners(view, at);
  if (threads.size() != 1) return {};
  std::vector<StepEffect> all;
  for (std::size_t s = 0; s < at.size(); ++s) {
    if (!at[s] || view.forest.segments.owner(static_cast<int>(s)) < 0) continue;
    for (int n : nodes_with(view, static_cast<int>(s))) all.push_back({n, static_cast<int>(s)});
  }
  return greater(least_by_source(view, all), by_the_way(view, at, *threads.begin()));
}

Bound interval_bound(const View& view, const Requirement& requirement) {
  return requirement.at_least ? least_interval(view, requirement)
                              : greatest_interval(view, requirement.at, false);
}

Bound pause_bound(const View& view, const std::vector<bool>& at) {
  return greatest_interval(view, at, true);
}

}  // namespace pal::analyzer::compositional
