// Samples and reactions: how old what a thread knows can be where it is used, and until something newer is.
#include <algorithm>

#include "analyzer/compositional/knowledge.hpp"

namespace pal::analyzer::compositional {
namespace {

Nanoseconds since_known(const Knowledge& knowledge, Pass pass, Nanoseconds until) {
  const Nanoseconds known = knowledge.at(pass);
  return known <= Knowledge::nothing || until >= never ? never : until - known;
}

/// From what one effect reflects to the next effect of the same thread.
Bound in_thread(const View& view, const Knowledge& knowledge, const Requirement& requirement, int thread) {
  const auto t = static_cast<std::size_t>(thread);
  const std::string& name = view.problem.threads[t].name;
  Passes passes(view, thread, requirement.at);
  if (passes.in_rounds().empty()) {
    // Once each, at the start.
    const Bound none{never, "nothing bounds when " + name + " comes to it"};
    const Way way = passes.from_entry();
    if (!view.lively[t] || way.home || way.lost) return none;
    Nanoseconds greatest = way.latest;
    for (const Pass& pass : passes.before_rounds()) {
      const int source = view.forest.nodes[static_cast<std::size_t>(pass.node)].source;
      const Way next = passes.after(pass);
      if (view.forest.sources[static_cast<std::size_t>(source)].kind != Source::Kind::start || next.home ||
          next.lost) {
        return none;
      }
      greatest = std::max(greatest, since_known(knowledge, pass, next.latest));
    }
    return {greatest, none.why};
  }
  if (!goes_on(view, thread) || !passes.every_round()) {
    const std::string& trouble = view.times.trouble[t];
    return {never, trouble.empty() ? name + " need not come to it in every round" : trouble};
  }
  Nanoseconds greatest = plus(passes.first(), passes.latest());
  Nanoseconds finish = 0;
  for (int n : view.conduct.threads[t].nodes) {
    if (in_paced_round(view, n))
      finish = std::max(finish, view.times.nodes[static_cast<std::size_t>(n)].finish);
  }
  const Nanoseconds next = plus(passes.gap(), passes.latest());
  for (const Pass& pass : passes.in_rounds()) {
    greatest = std::max(greatest, since_known(knowledge, pass, next));
    // A statement that a cancelled block finishes.
    if (view.conduct.threads[t].may_be_cancelled)
      greatest = std::max(greatest, since_known(knowledge, pass, finish));
  }
  return {greatest, "nothing bounds how old what " + name + " knows can be"};
}

}  // namespace

Bound known_age_bound(const View& view, const Requirement& requirement) {
  const Knowledge knowledge(view, requirement);
  Nanoseconds oldest = 0;
  for (std::size_t s = 0; s < view.problem.steps.size(); ++s) {
    if (!requirement.at[s] || view.forest.segments.owner(static_cast<int>(s)) < 0) continue;
    for (int n : nodes_with(view, static_cast<int>(s))) {
      const Pass pass{n, static_cast<int>(s)};
      const Nanoseconds latest = latest_effect(view.forest, view.times, n, pass.step);
      oldest = std::max(oldest, since_known(knowledge, pass, latest));
    }
  }
  return {oldest, "nothing bounds how old the sample is that is known there"};
}

Bound reaction_bound(const View& view, const Requirement& requirement) {
  const std::set<int> threads = owners(view, requirement.at);
  const Knowledge knowledge(view, requirement);
  Bound least{never, "no thread comes to it"};
  for (int thread : threads) {
    // One of several must go on for as long as any of them.
    const auto t = static_cast<std::size_t>(thread);
    const ThreadConduct& of = view.conduct.threads[t];
    if (threads.size() > 1 && (of.leaves || of.may_be_cancelled || !goes_on(view, thread))) continue;
    const Bound bound = in_thread(view, knowledge, requirement, thread);
    if (bound.value < least.value || least.value >= never) least = bound;
  }
  return least;
}

}  // namespace pal::analyzer::compositional
