// How far apart effects of statements can be, and how near.
#include <algorithm>

#include "analyzer/compositional/passes.hpp"

namespace pal::analyzer::compositional {
namespace {

Nanoseconds earliest_of(const View& view, Pass pass) {
  return earliest_effect(view.forest, view.times, pass.node, pass.step);
}

/// From an effect in one thread to the next.
Bound greatest_in(const View& view, const std::vector<bool>& at, int thread, bool from_start) {
  const auto t = static_cast<std::size_t>(thread);
  const std::string& name = view.problem.threads[t].name;
  Passes passes(view, thread, at);
  const ThreadConduct& of = view.conduct.threads[t];
  const std::string& trouble = view.times.trouble[t];
  const Bound none{never, trouble.empty() ? name + " need not come to it in every round" : trouble};
  const bool rounds = of.home >= 0 || starts_in_rounds(view, thread);
  if (rounds ? !goes_on(view, thread) : !view.lively[t]) return none;
  Nanoseconds greatest = from_start ? plus(passes.first(), passes.latest()) : 0;
  if (from_start && !passes.every_round()) return none;
  Nanoseconds finish = 0;
  for (int n : of.nodes) {
    if (in_paced_round(view, n))
      finish = std::max(finish, view.times.nodes[static_cast<std::size_t>(n)].finish);
  }
  const auto follow = [&](Pass pass, Nanoseconds apart) {
    const Way way = passes.after(pass);
    const Nanoseconds begun = earliest_of(view, pass);
    if (way.lost || (way.home && !passes.every_round())) return never;
    const Nanoseconds next = way.home ? plus(apart, passes.latest()) : 0;
    if (next >= never) return never;
    // What a cancelled block has begun it finishes.
    return std::max({way.latest, next, of.may_be_cancelled ? finish : 0}) - begun;
  };
  for (const Pass& pass : passes.in_rounds()) greatest = std::max(greatest, follow(pass, passes.gap()));
  for (const Pass& pass : passes.before_rounds()) greatest = std::max(greatest, follow(pass, passes.first()));
  return {greatest, none.why};
}

Bound greatest_interval(const View& view, const Requirement& requirement) {
  const std::set<int> threads = owners(view, requirement.at);
  Bound least{never, "no thread comes to it"};
  for (int thread : threads) {
    const ThreadConduct& of = view.conduct.threads[static_cast<std::size_t>(thread)];
    // One of several must go on for as long as any of them.
    if (threads.size() > 1 && (of.leaves || of.may_be_cancelled || !goes_on(view, thread))) continue;
    const Bound bound = greatest_in(view, requirement.at, thread, threads.size() > 1);
    if (bound.value < least.value || least.value >= never) least = bound;
  }
  return least;
}

/// If each occurrence of one source brings one effect at most: from the latest in one round to the earliest
/// in the next.
Nanoseconds least_by_source(const View& view, const std::vector<Pass>& all) {
  if (all.empty()) return 0;
  const int source = view.forest.nodes[static_cast<std::size_t>(all.front().node)].source;
  const Source& of = view.forest.sources[static_cast<std::size_t>(source)];
  if (of.period >= never) return 0;
  Nanoseconds earliest = never;
  Nanoseconds latest = 0;
  for (const Pass& pass : all) {
    if (pass.node != all.front().node) return 0;
    const Segment& segment = view.forest.segment_of(view.forest.nodes[static_cast<std::size_t>(pass.node)]);
    for (const Pass& other : all) {
      if (comes_after(view.problem, segment, pass.step, other.step)) return 0;
    }
    earliest = std::min(earliest, earliest_of(view, pass));
    latest = std::max(latest, latest_effect(view.forest, view.times, pass.node, pass.step));
  }
  return latest >= never ? 0 : std::max<Nanoseconds>(0, of.period + earliest - latest);
}

Bound least_interval(const View& view, const Requirement& requirement) {
  const Bound none{never, "nothing keeps two passes apart"};
  const std::set<int> threads = owners(view, requirement.at);
  if (threads.size() != 1) return none;
  const int thread = *threads.begin();
  std::vector<Pass> all;
  for (std::size_t s = 0; s < requirement.at.size(); ++s) {
    if (!requirement.at[s] || view.forest.segments.owner(static_cast<int>(s)) < 0) continue;
    for (int n : nodes_with(view, static_cast<int>(s))) all.push_back({n, static_cast<int>(s)});
  }
  const Nanoseconds least = std::max(
      least_by_source(view, all), least_way(view.problem, thread, requirement.at, view.conduct.sequential));
  if (least >= never) return {never, "it comes once at most"};
  return least > 0 ? Bound{least, ""} : none;
}

}  // namespace

Bound interval_bound(const View& view, const Requirement& requirement) {
  return requirement.at_least ? least_interval(view, requirement) : greatest_interval(view, requirement);
}

}  // namespace pal::analyzer::compositional
