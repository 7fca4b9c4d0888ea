// How old a condition is where it is used.
#include <algorithm>

#include "analyzer/compositional/measures/staleness.hpp"
#include "analyzer/compositional/times/slots.hpp"
#include "analyzer/machine/watch.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;

/// The statement's thread is gone through backwards to the reads, and the thread that sets is asked how long
/// its sets can be apart. Reads and sets in one thread: through the read, backwards to the set.
class Ageing {
 public:
  Ageing(const View& view, const Requirement& requirement)
      : view_(view), problem_(view.problem), requirement_(requirement) {
    before_.resize(problem_.steps.size());
    for (std::size_t s = 0; s < problem_.steps.size(); ++s) {
      for (int next : problem_.steps[s].next)
        before_[static_cast<std::size_t>(next)].push_back(static_cast<int>(s));
    }
    for (std::size_t s = 0; s < problem_.steps.size(); ++s) {
      const Step& step = problem_.steps[s];
      if (owner(static_cast<int>(s)) < 0 || step.condition != requirement.condition) continue;
      if (step.kind == Kind::set) setters_.insert(owner(static_cast<int>(s)));
      if (step.kind == Kind::read) latching_.insert(owner(static_cast<int>(s)));
    }
  }

  Bound run() {
    Sum oldest;
    for (std::size_t s = 0; s < problem_.steps.size(); ++s) {
      if (!requirement_.at[s] || owner(static_cast<int>(s)) < 0) continue;
      oldest = greater(oldest, at_statement(static_cast<int>(s)));
      if (!oldest.bounded())
        return {oldest, why_.empty() ? "nothing bounds how long ago the value was read or set" : why_};
    }
    return {oldest, ""};
  }

 private:
  int owner(int step) const { return view_.forest.segments.owner(step); }
  const Step& step_at(int step) const { return problem_.steps[static_cast<std::size_t>(step)]; }
  const ThreadBehaviour& behaviour(int thread) const {
    return view_.behaviours.threads[static_cast<std::size_t>(thread)];
  }
  const Node& node(int n) const { return view_.forest.nodes[static_cast<std::size_t>(n)]; }
  const Segment& segment(int n) const { return view_.forest.segment_of(node(n)); }

  bool reads(int step) const {
    return (step_at(step).kind == Kind::read && step_at(step).condition == requirement_.condition) ||
           tests(step_at(step), requirement_.condition);
  }
  /// Whatever was read before does not count any more.
  bool surely_reads(int step) const {
    return reads(step) && (step_at(step).kind == Kind::read || !latching_.contains(owner(step)));
  }
  bool sets(int step) const {
    return step_at(step).kind == Kind::set && step_at(step).condition == requirement_.condition;
  }

  struct Place {
    int step;
    int jobs;  // how many jobs end on the way from here to the statement
    auto operator<=>(const Place&) const = default;
  };

  /// Goes back from a place. `visit` says whether to go on before a step; `begin` is called if the way leads
  /// to the beginning of the thread.
  template <class Visit, class Begin>
  void back(Place from, const Visit& visit, const Begin& begin) const {
    const int thread = owner(from.step);
    const int idle_wait = behaviour(thread).idle_wait;
    std::set<Place> seen;
    std::vector<Place> open;
    const auto leave = [&](Place at) {
      const int jobs = at.jobs + (at.step == idle_wait ? 1 : 0);
      if (problem_.threads[static_cast<std::size_t>(thread)].entry == at.step) begin(jobs);
      for (int step : before_[static_cast<std::size_t>(at.step)]) open.push_back({step, std::min(jobs, 3)});
    };
    leave(from);
    while (!open.empty()) {
      const Place at = open.back();
      open.pop_back();
      if (seen.insert(at).second && visit(at)) leave(at);
    }
  }

  Sum at_statement(int statement) {
    const int thread = owner(statement);
    Sum oldest;
    if (reads(statement)) oldest = since_set({statement, 0}, statement);
    if (surely_reads(statement)) return oldest;
    back(
        {statement, 0},
        [&](Place at) {
          if (reads(at.step)) oldest = greater(oldest, since_set(at, statement));
          return oldest.bounded() && !surely_reads(at.step);
        },
        [&](int) {
          // What its parent had read.
          if (problem_.threads[static_cast<std::size_t>(thread)].parent >= 0 &&
              somebody_reads_above(thread)) {
            oldest = Sum::unbounded();
          }
        });
    return oldest;
  }

  bool somebody_reads_above(int thread) const {
    for (int above = problem_.threads[static_cast<std::size_t>(thread)].parent; above >= 0;
         above = problem_.threads[static_cast<std::size_t>(above)].parent) {
      for (std::size_t s = 0; s < problem_.steps.size(); ++s) {
        if (owner(static_cast<int>(s)) == above && reads(static_cast<int>(s))) return true;
      }
    }
    return false;
  }

  /// From the set whose value `read` gets to the statement.
  Sum since_set(Place read, int statement) {
    const int thread = owner(statement);
    if (setters_.size() == 1 && setters_.contains(thread)) {
      Sum oldest;
      back(
          read,
          [&](Place at) {
            if (!sets(at.step)) return oldest.bounded();
            // A set before itself, in a loop away from the idle wait: its time is unbounded.
            const bool elsewhere = at.step == statement && at.jobs == 0;
            oldest = greater(oldest, elsewhere ? Sum::unbounded() : distance(at, statement));
            return false;
          },
          [&](int jobs) {
            const bool block = problem_.threads[static_cast<std::size_t>(thread)].parent >= 0;
            oldest = greater(oldest, block ? Sum::unbounded() : from_start(statement, jobs));
          });
      return oldest;
    }
    const Bound age = value_age(view_, requirement_.condition, thread);
    if (!age.known()) why_ = age.why;
    return age.sum + distance(read, statement);
  }

  /// An unbounded thread may still be in what it began before its idle wait.
  bool unbounded(int thread) const {
    return !view_.times.unbounded_reason[static_cast<std::size_t>(thread)].empty();
  }

  /// Whether the next job of a thread is that of the next occurrence of their source.
  bool in_turn(int thread) const {
    return source_of_jobs(view_, thread) >= 0 && regular(view_, thread) && in_order(view_, thread);
  }

  Sum from_start(int statement, int jobs) {
    if (jobs > 0 && unbounded(owner(statement))) return Sum::unbounded();
    Sum longest;
    const int source = source_of_jobs(view_, owner(statement));
    for (int n : nodes_with(view_, statement)) {
      const Sum effect = latest(view_, n, statement);
      const bool anew =
          view_.forest.sources[static_cast<std::size_t>(node(n).source)].kind == Source::Kind::joined;
      if (!in_job(view_, n)) {
        longest = greater(longest, jobs > 0 ? Sum() : anew ? Sum::unbounded() : effect);
      } else if (jobs <= 1 && in_turn(owner(statement))) {
        longest = greater(longest, first(view_, source) + effect);
      } else {
        longest = Sum::unbounded();
      }
    }
    return longest;
  }

  /// From the effect of a step to that of the statement, in one thread.
  Sum distance(Place from, int statement) {
    const int thread = owner(statement);
    if (from.step == statement && from.jobs == 0) return {};
    if (from.jobs > 0 && unbounded(thread)) return Sum::unbounded();
    const int source = source_of_jobs(view_, thread);
    Sum longest;
    for (int a : nodes_with(view_, from.step)) {
      for (int b : nodes_with(view_, statement)) {
        const Sum sooner = earliest(view_, a, from.step);
        const Sum later = latest(view_, b, statement);
        if (!later.bounded()) return later;
        const bool same = view_.behaviours.job_start[static_cast<std::size_t>(a)] ==
                          view_.behaviours.job_start[static_cast<std::size_t>(b)];
        // Nobody knows how long the blocks of a CONCURRENT between the two went on.
        const auto anew = [this](int n) {
          return view_.forest.sources[static_cast<std::size_t>(node(n).source)].kind == Source::Kind::joined;
        };
        if (from.jobs == 0 && node(a).source != node(b).source && (anew(a) || anew(b)))
          return Sum::unbounded();
        if (from.jobs == 0) {
          if (a == b) {
            const Sum distance = later - sooner;
            const bool held = may_be_held(b, statement);
            longest =
                greater(longest, held ? distance : less(distance, without_pause(a, from.step, statement)));
          } else if (same) {
            longest = greater(longest, later - sooner);
          }
          continue;
        }
        if (!in_job(view_, b)) continue;
        if (from.jobs > 1 || !in_turn(thread)) return Sum::unbounded();
        const Sum distance = in_job(view_, a) ? gap(view_, source) : first(view_, source);
        longest = greater(longest, distance + later - sooner);
      }
    }
    return longest;
  }

  /// Whether a statement is a send that may have to wait for its slot.
  bool may_be_held(int n, int statement) const {
    const AnalysisContext context{problem_, view_.forest, view_.behaviours};
    return held_until(context, view_.times.nodes, n, statement) >
           earliest_effect(view_.forest, view_.times, n, statement);
  }

  /// From one effect to another in one segment, if no send waits for its slot.
  Sum without_pause(int n, int from, int to) const {
    std::map<int, Nanoseconds> longest{{from, 0}};
    for (const Segment::Passed& passed : segment(n).steps) {
      const auto known = longest.find(passed.step);
      if (known == longest.end()) continue;
      const Nanoseconds here = known->second;
      const std::vector<int>& next = step_at(passed.step).next;
      for (int after : next) {
        Nanoseconds& there = longest[after];
        there = std::max(there, here + step_at(after).cost.worst);
      }
    }
    const Thread& thread = problem_.threads[static_cast<std::size_t>(owner(to))];
    const auto found = longest.find(to);
    if (found == longest.end()) return Sum::unbounded();
    const Nanoseconds all = view_.windows().stretch(thread.processor, thread.priority, found->second);
    return {all, {Term::Kind::said, n, to, -1, "runs, and is preempted, from the read to the statement"}};
  }

  const View& view_;
  const Problem& problem_;
  const Requirement& requirement_;
  std::vector<std::vector<int>> before_;
  std::set<int> setters_;
  std::set<int> latching_;
  std::string why_;
};

}  // namespace

Bound age_bound(const View& view, const Requirement& requirement) {
  const Bound known = known_age_bound(view, requirement);
  if (requirement.condition < 0) return known;
  const Bound aged = Ageing(view, requirement).run();
  return known.sum.value() < aged.sum.value() ? known : aged;
}

}  // namespace pal::analyzer::compositional
