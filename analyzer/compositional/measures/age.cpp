// How old a condition is where it is used.
#include <algorithm>

#include "analyzer/compositional/measures/staleness.hpp"
#include "analyzer/compositional/times/slots.hpp"
#include "analyzer/machine/watch.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;

/// The statement's thread is gone through backwards to the reads of its segment, and the threads that set are
/// asked how long their sets can be apart. What was read before is known_age_bound()'s matter.
class Ageing {
 public:
  Ageing(const View& view, const Requirement& requirement)
      : view_(view), problem_(view.problem), requirement_(requirement) {
    before_.resize(problem_.steps.size());
    for (const StepId s : problem_.steps.ids()) {
      for (StepId next : problem_.steps[s].next) before_[next].push_back(s);
      const Step& step = problem_.steps[s];
      if (step.kind == Kind::read && step.condition == requirement.condition) latching_.insert(owner(s));
    }
  }

  Bound run() {
    Sum oldest;
    for (const StepId s : problem_.steps.ids()) {
      if (!requirement_.at[s] || !owner(s).valid()) continue;
      oldest = greater(oldest, at_statement(s));
      if (!oldest.bounded()) return {oldest, why_.empty() ? why(Withheld::read_unknown) : why_};
    }
    return {oldest};
  }

 private:
  ThreadId owner(StepId step) const { return view_.forest.segments.owner(step); }
  const Step& step_at(StepId step) const { return problem_.steps[step]; }
  const Segment& segment(NodeId n) const { return view_.forest.segment_of(view_.forest.nodes[n]); }

  bool reads(StepId step) const {
    return (step_at(step).kind == Kind::read && step_at(step).condition == requirement_.condition) ||
           tests(step_at(step), requirement_.condition);
  }
  /// Whatever was read before does not count any more.
  bool surely_reads(StepId step) const {
    return reads(step) && (step_at(step).kind == Kind::read || !latching_.contains(owner(step)));
  }

  Sum at_statement(StepId statement) {
    Sum oldest;
    std::set<StepId> seen;
    std::vector<StepId> open;
    const auto leave = [&](StepId at) {
      const Thread& thread = problem_.threads[owner(at)];
      const bool waited = step_at(at).kind == Kind::wait || step_at(at).kind == Kind::fork;
      if (waited || (thread.entry == at && thread.parent.valid())) oldest = Sum::unbounded();
      const std::vector<StepId>& before = before_[at];
      open.insert(open.end(), before.begin(), before.end());
    };
    if (reads(statement)) oldest = since_set(statement, statement);
    if (!surely_reads(statement)) leave(statement);
    while (!open.empty() && oldest.bounded()) {
      const StepId at = open.back();
      open.pop_back();
      if (!seen.insert(at).second) continue;
      if (reads(at)) oldest = greater(oldest, since_set(at, statement));
      if (!surely_reads(at)) leave(at);
    }
    return oldest;
  }

  /// From the set whose value `read` gets to the statement.
  Sum since_set(StepId read, StepId statement) {
    const Bound age = value_age(view_, requirement_.condition, owner(statement));
    if (!age.known()) why_ = age.why;
    return age.sum + distance(read, statement);
  }

  /// From the effect of a step to that of the statement, in one segment.
  Sum distance(StepId from, StepId statement) {
    if (from == statement) return {};
    Sum longest;
    const std::vector<NodeId> nodes = nodes_with(view_, from);
    for (NodeId n : nodes_with(view_, statement)) {
      if (std::find(nodes.begin(), nodes.end(), n) == nodes.end()) continue;
      const Sum later = latest(view_, n, statement);
      if (!later.bounded()) return later;
      const Sum all = later - earliest(view_, n, from);
      longest =
          greater(longest, may_be_held(n, statement) ? all : less(all, without_pause(n, from, statement)));
    }
    return longest;
  }

  /// Whether a statement is a send that may have to wait for its slot.
  bool may_be_held(NodeId n, StepId statement) const {
    const AnalysisContext context{problem_, view_.forest, view_.behaviours};
    return held_until(context, view_.times.nodes, n, statement) >
           earliest_effect(view_.forest, view_.times, n, statement);
  }

  /// From one effect to another in one segment, if no send waits for its slot.
  Sum without_pause(NodeId n, StepId from, StepId to) const {
    std::map<StepId, Nanoseconds> longest{{from, 0}};
    for (const Segment::Passed& passed : segment(n).steps) {
      const auto known = longest.find(passed.step);
      if (known == longest.end()) continue;
      const Nanoseconds here = known->second;
      const std::vector<StepId>& next = step_at(passed.step).next;
      for (StepId after : next) {
        Nanoseconds& there = longest[after];
        there = std::max(there, here + step_at(after).cost.worst);
      }
    }
    const Thread& thread = problem_.threads[owner(to)];
    const auto found = longest.find(to);
    if (found == longest.end()) return Sum::unbounded();
    const Nanoseconds all = view_.windows().stretch(thread.processor, thread.priority, found->second);
    return {all, {Term::Kind::said, n, to, {}, "runs, and is preempted, from the read to the statement"}};
  }

  const View& view_;
  const Problem& problem_;
  const Requirement& requirement_;
  Table<StepId, std::vector<StepId>> before_;
  std::set<ThreadId> latching_;
  Why why_;
};

}  // namespace

Bound age_bound(const View& view, const Requirement& requirement) {
  const Bound known = known_age_bound(view, requirement);
  if (!requirement.condition.valid()) return known;
  const Bound aged = Ageing(view, requirement).run();
  return known.sum.value() < aged.sum.value() ? known : aged;
}

}  // namespace pal::analyzer::compositional
