#include "analyzer/compositional/measures/data_freshness.hpp"

#include <algorithm>
#include <utility>

#include "analyzer/compositional/measures/reasons.hpp"
#include "analyzer/compositional/measures/staleness.hpp"
#include "analyzer/machine/watch.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;
using Release = Node::Release;

constexpr int most_freshness_rounds = 60;
using Instant = DataFreshness::Instant;
using Known = DataFreshness::Known;

const Known unbounded = Instant{Sum::unbounded()};

/// Causes of a request that are tried, the nearest ones first.
constexpr int most_causes = 32;

bool is_bounded(const Known& known) {
  return known && known->at.bounded();
}

/// `known`, if anything, earlier by `by`.
Known earlier(const Known& known, const Sum& by) {
  return known && by.bounded() ? Known(Instant{known->at - by}) : std::nullopt;
}

bool same_request(const Instant& one, const Instant& other) {
  if (!one.request || !other.request) return !one.request && !other.request;
  return one.request->node == other.request->node && one.request->step == other.request->step;
}

/// What is known when both apply; also when one of them applies, and it is unknown which.
Known both(const Known& one, const Known& other) {
  if (!one || !other) return one ? one : other;
  return other->at.value() > one->at.value() ? other : one;
}
Known either(const Known& one, const Known& other) {
  if (!one || !other) return std::nullopt;
  if (!one->at.bounded() || !other->at.bounded()) return one->at.bounded() ? one : other;
  const bool same = same_request(*one, *other);
  return Known({less(one->at, other->at), same ? one->request : std::nullopt});
}

bool same(const Known& one, const Known& other) {
  if (!one || !other) return !one && !other;
  return one->at.value() == other->at.value() && same_request(*one, *other);
}

}  // namespace

DataFreshness::DataFreshness(const View& view, const Requirement& requirement)
    : view_(view),
      problem_(view.problem),
      requirement_(requirement),
      since_cause_(view.times.interference->since_cause()),
      begins_(view.forest.nodes.size()),
      effects_(view.forest.nodes.size()),
      arrivals_(view.forest.nodes.size()),
      latched_(problem_.threads.size()) {
  for (const ThreadId t : problem_.threads.ids()) regular_.push_back(regular(view, t));
  for (const StepId s : problem_.steps.ids()) {
    const ThreadId owner = view.forest.segments.owner(s);
    if (owner.valid() && problem_.steps[s].kind == Kind::read)
      latched_[owner].insert(problem_.steps[s].condition);
  }
  if (!requirement.condition.valid()) find_setters();
  for (int iteration = 0; iteration < most_freshness_rounds; ++iteration) {
    if (!requirement.condition.valid()) ages_.clear();  // samples on their way to conditions
    bool changed = false;
    for (const NodeId n : begins_.ids()) changed = visit(n) || changed;
    if (!changed) return;
  }
}

Known DataFreshness::at(StepEffect effect) const {
  const Segment& segment = view_.forest.segment_of(view_.forest.nodes[effect.node]);
  const auto& effects = effects_[effect.node];
  for (std::size_t s = 0; s < segment.steps.size() && s < effects.size(); ++s) {
    if (segment.steps[s].step == effect.step) return effects[s];
  }
  return std::nullopt;
}

Sum DataFreshness::age_since_cause(StepEffect effect) const {
  Sum least = Sum::unbounded();
  const Known known = at(effect);
  if (!known || !known->request) return least;
  const StepEffect request = *known->request;
  const AnalysisContext context{problem_, view_.forest, view_.behaviours};
  NodeId cause = request.node;
  for (int tried = 0; cause.valid() && tried < most_causes; ++tried, cause = context.node(cause).cause) {
    if (!since_cause_.counts_from(cause, effect.node)) continue;
    const Segment& segment = context.segment(request.node);
    const Nanoseconds soonest =
        plus(since_cause_.least(cause, request.node), segment.steps[place_of(segment, request.step)].best);
    const Sum latest = since_cause(view_, cause, effect);
    least = less(least, latest - Sum(soonest, {Term::Kind::earliest, request.node, request.step, {}, ""}));
  }
  return least;
}

void DataFreshness::find_setters() {
  for (const StepId s : problem_.steps.ids()) {
    if (problem_.steps[s].kind != Kind::set) continue;
    auto& at = set_at_[problem_.steps[s].condition];
    at.resize(problem_.steps.size());
    at[s] = true;
  }
  for (const auto& [condition, at] : set_at_) {
    for (ThreadId thread : owners(view_, at))
      setters_[condition].push_back({thread, std::make_unique<StatementOccurrences>(view_, thread, at)});
  }
}

/// Follows the node's ways; true: something more is known than before.
bool DataFreshness::visit(NodeId node) {
  const NodeId n = node;
  const Segment& segment = view_.forest.segment_of(view_.forest.nodes[n]);
  const Beginning& begins = segment.beginning;
  State first = begin(node);
  first.known = both(first.known, begins_[n].known);
  first.set = both(first.set, begins_[n].set);
  const bool changed = !same(first.known, begins_[n].known) || !same(first.set, begins_[n].set);
  begins_[n] = first;
  std::map<StepId, State> reached;
  const auto reach = [&](StepId step, const State& state) {
    const auto [place, fresh] = reached.emplace(step, state);
    if (fresh) return;
    place->second.known = either(place->second.known, state.known);
    place->second.set = either(place->second.set, state.set);
  };
  std::vector<Known> effects;
  const bool after_wait = begins.kind == Beginning::Kind::arm || begins.kind == Beginning::Kind::give_up;
  if (begins.kind == Beginning::Kind::entry) {
    reach(problem_.threads[begins.thread].entry, first);
  } else {
    const Step& step = problem_.steps[begins.step];
    if (after_wait) effects.push_back(first.known);
    const bool arm = begins.kind == Beginning::Kind::arm;
    const bool joined = begins.kind == Beginning::Kind::joined;
    reach(joined ? step.next.front()
          : arm  ? step.next[static_cast<std::size_t>(begins.arm)]
                 : step.next.back(),
          first);
  }
  for (std::size_t s = after_wait ? 1 : 0; s < segment.steps.size(); ++s) {
    const StepId step = segment.steps[s].step;
    State state = reached.at(step);
    transfer(node, step, state);
    effects.push_back(state.known);
    for (StepId next : problem_.steps[step].next) reach(next, state);
  }
  const bool more =
      changed || !std::equal(effects.begin(), effects.end(), effects_[n].begin(), effects_[n].end(), same);
  effects_[n] = std::move(effects);
  arrivals_[n] = std::move(reached);
  return more;
}

DataFreshness::State DataFreshness::begin(NodeId node) const {
  const NodeId n = node;
  const Node& of = view_.forest.nodes[n];
  State state;
  const auto arrived = [this](NodeId before, StepId step) {
    const auto& arrivals = arrivals_[before];
    const auto found = arrivals.find(step);
    return found == arrivals.end() ? State{} : found->second;
  };
  const auto& previous = view_.behaviours.previous[n];
  if (!previous.empty()) {
    state = {unbounded, unbounded};
    for (NodeId before : previous) {
      const State there = arrived(before, view_.forest.segment_of(of).beginning.step);
      state.known = either(state.known, there.known);
      state.set = either(state.set, there.set);
    }
  } else if (of.release == Release::fork && of.cause.valid()) {
    state = arrived(of.cause, of.cause_step);
  } else if (in_recurring_job(view_, node)) {
    state = before_idle(node);
  }
  if (of.release == Release::fork && view_.forest.segment_of(of).beginning.kind == Beginning::Kind::joined)
    state.set = both(state.set, set_by_blocks(of));
  // At time 0 no more is known, and a condition has its first value.
  if (view_.forest.sources[of.source].kind == Source::Kind::start) {
    state.known = both(state.known, Known(Instant()));
    state.set = both(state.set, Known(Instant()));
  }
  state.known = both(state.known, told(node));
  return state;
}

/// Last set by the blocks that have ended when a node begins.
Known DataFreshness::set_by_blocks(const Node& joined) const {
  Known latest;
  for (ThreadId block : problem_.steps[joined.cause_step].threads) {
    if (!problem_.threads[block].can_end) continue;
    Known soonest = unbounded;
    for (NodeId n : view_.behaviours.threads[block].nodes) {
      const NodeId job_start = view_.behaviours.job_start[n];
      if (view_.forest.nodes[job_start].cause != joined.cause) continue;
      for (const auto& [step, state] : arrivals_[n]) {
        if (problem_.steps[step].kind == Kind::end) soonest = either(soonest, state.set);
      }
    }
    if (is_bounded(soonest)) latest = both(latest, soonest);
  }
  return latest;
}

bool DataFreshness::overtakes(ThreadId thread) const {
  return view_.withholds(Withheld::jobs_overtake) && !in_order(view_, thread);
}

Why DataFreshness::with_reason(Why what, ThreadId thread) const {
  const bool known = recurring_source(view_, thread).valid() && regular_[thread];
  if (known && overtakes(thread))
    return since(std::move(what), why(Withheld::jobs_overtake, problem_.threads[thread].name));
  return with_unbounded_reason(std::move(what), view_, thread);
}

/// From the previous job; the first job begins with what is younger than the skill.
DataFreshness::State DataFreshness::before_idle(NodeId node) const {
  const ThreadId thread = view_.forest.thread_of(node);
  const SourceId source = recurring_source(view_, thread);
  if (!source.valid() || !regular_[thread]) return {};
  if (overtakes(thread)) return {};
  const ThreadBehaviour& of = view_.behaviours.threads[thread];
  State state{unbounded, unbounded};
  for (NodeId other : of.nodes) {
    if (!in_recurring_job(view_, other)) continue;
    const auto& arrivals = arrivals_[other];
    const Segment& segment = view_.forest.segment_of(view_.forest.nodes[other]);
    for (const Segment::Arrival& wait : segment.waits) {
      if (wait.step != of.idle_wait) continue;
      const auto found = arrivals.find(of.idle_wait);
      const State there = found == arrivals.end() ? State{} : found->second;
      state.known = either(state.known, there.known);
      state.set = either(state.set, there.set);
    }
  }
  const Sum distance = gap(view_, source);
  const Sum begin = first(view_, source);
  const auto since = [&](const Known& before) -> Known {
    if (before && !before->at.bounded()) return std::nullopt;  // it never returns to its idle wait
    return either(earlier(before, distance), earlier(Known(Instant()), begin));
  };
  return {since(state.known), since(state.set)};
}

bool DataFreshness::sampled(ChannelId channel) const {
  const auto& samples = requirement_.samples;
  return std::find(samples.begin(), samples.end(), channel) != samples.end();
}

/// By the message that begins the node.
Known DataFreshness::told(NodeId node) const {
  if (requirement_.condition.valid()) return std::nullopt;
  const Node& of = view_.forest.nodes[node];
  const Source& source = view_.forest.sources[of.source];
  if (of.release == Release::message) return told_by(of.cause, of.sends, of.device);
  if (of.release != Release::root) return std::nullopt;
  if (source.kind == Source::Kind::event) {
    const ChannelId event = problem_.devices[source.device].event;
    return sampled(event) ? Known(Instant()) : std::nullopt;
  }
  return source.kind == Source::Kind::loop ? told_in_loop(source, of.source) : std::nullopt;
}

/// A message carries what its sender knows; a device's answer says what was so after the request.
Known DataFreshness::told_by(NodeId sender, const std::vector<StepId>& sends, DeviceId device) const {
  Known known = unbounded;
  for (StepId send : sends) {
    if (!device.valid()) {
      known = either(known, at({sender, send}));
      continue;
    }
    const ChannelId request = problem_.steps[send].channels.front();
    const ChannelId answer = problem_.channels[request].answer;
    known = either(known, sampled(answer) ? Known({earliest(view_, sender, send), StepEffect{sender, send}})
                                          : std::nullopt);
  }
  return is_bounded(known) ? known : std::nullopt;
}

/// By what leads to the next job of a loop.
Known DataFreshness::told_in_loop(const Source& source, SourceId index) const {
  Known known = unbounded;
  for (const Source::Feed& feed : source.feeds) {
    if (!feed.node.valid() || feed.sends.empty()) return std::nullopt;
    const SourceId from = view_.forest.nodes[feed.node].source;
    const bool own = from == index;
    if (!own && view_.forest.sources[from].kind != Source::Kind::start) return std::nullopt;
    const Sum distance = own ? gap(view_, index) : first(view_, index);
    known = either(known, earlier(told_by(feed.node, feed.sends, feed.device), distance));
  }
  return is_bounded(known) ? known : std::nullopt;
}

/// Whether a step surely reads a condition, or has read it before for this very test.
bool DataFreshness::surely_read(StepId step, ConditionId condition) const {
  const Step& of = problem_.steps[step];
  if (of.kind == Kind::read) return of.condition == condition;
  const ThreadId thread = view_.forest.segments.owner(step);
  return tests(of, condition) && !latched_[thread].contains(condition);
}

void DataFreshness::transfer(NodeId node, StepId step, State& state) {
  const Step& of = problem_.steps[step];
  const ThreadId thread = view_.forest.thread_of(node);
  const Sum now = earliest(view_, node, step);
  if (requirement_.condition.valid()) {
    if (of.kind == Kind::set && of.condition == requirement_.condition) state.set = Known(Instant{now});
    if (surely_read(step, requirement_.condition)) {
      const Known read = earlier(Known(Instant{now}), age_when_read(requirement_.condition, thread));
      state.known = both(both(state.known, read), state.set);
    }
    return;
  }
  for (const auto& [condition, at] : set_at_) {
    if (!surely_read(step, condition)) continue;
    state.known = both(state.known, earlier(Known(Instant{now}), age_when_read(condition, thread)));
  }
}

Sum DataFreshness::age_when_read(ConditionId condition, ThreadId reader) {
  const auto [place, fresh] = ages_.emplace(std::pair{condition, reader}, Sum::unbounded());
  if (fresh) {
    place->second = requirement_.condition.valid() ? value_age(view_, condition, reader).sum
                                                   : sample_age(condition, reader);
  }
  return place->second;
}

/// Greatest time since the sample that a condition carries when it is read. Before the first set of a job
/// it is no longer than the skill has run.
Sum DataFreshness::sample_age(ConditionId condition, ThreadId reader) const {
  const auto found = setters_.find(condition);
  if (found == setters_.end()) return Sum::unbounded();
  Sum at_set;                       // age of the sample at any set
  Sum distance = Sum::unbounded();  // sets
  Sum until_first = Sum::unbounded();
  Sum together = Sum::unbounded();  // both, of the one setter
  bool later = false;               // sets that are neither in jobs nor at the start
  for (const Setter& setter : found->second) {
    const StatementOccurrences& sets = *setter.sets;
    const auto age = [&](StepEffect effect) {
      const Known known = at(effect);
      return known ? latest(view_, effect.node, effect.step) - known->at : Sum::unbounded();
    };
    Sum soonest = Sum::unbounded();
    Known known = unbounded;
    for (const StepEffect& effect : sets.in_jobs()) {
      soonest = less(soonest, earliest(view_, effect.node, effect.step));
      known = either(known, at(effect));
      at_set = greater(at_set, age(effect));
    }
    for (const StepEffect& effect : sets.before_jobs()) {
      const SourceId source = view_.forest.nodes[effect.node].source;
      later = later || view_.forest.sources[source].kind != Source::Kind::start;
      at_set = greater(at_set, age(effect));
    }
    if (!sets.in_every_job() || sets.in_jobs().empty() || !outlasts(view_, setter.thread, reader)) continue;
    const Sum& set_again = replaced(view_, sets, setter.thread, reader);
    const Sum next = sets.next_or_end(set_again);
    until_first = less(until_first, sets.first_or_end(set_again));
    distance = less(distance, next - soonest);
    if (known) together = next - known->at;
  }
  if (found->second.size() > 1 || later) together = distance + at_set;
  return greater(together, until_first);
}

}  // namespace pal::analyzer::compositional
