#include "analyzer/compositional/knowledge.hpp"

#include <algorithm>

#include "analyzer/compositional/staleness.hpp"
#include "analyzer/watch.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;
using Release = Node::Release;

constexpr int most_passes = 60;
constexpr Nanoseconds nothing = Knowledge::nothing;

/// `known`, if anything, so much earlier.
Nanoseconds earlier(Nanoseconds known, Nanoseconds by) {
  return known <= nothing || by >= never ? nothing : known - by;
}

}  // namespace

Knowledge::Knowledge(const View& view, const Requirement& requirement)
    : view_(view),
      problem_(view.problem),
      requirement_(requirement),
      begins_(view.forest.nodes.size()),
      effects_(view.forest.nodes.size()),
      arrivals_(view.forest.nodes.size()),
      latched_(problem_.threads.size()) {
  for (std::size_t t = 0; t < problem_.threads.size(); ++t)
    regular_.push_back(regular(view, static_cast<int>(t)));
  for (std::size_t s = 0; s < problem_.steps.size(); ++s) {
    const int owner = view.forest.segments.owner(static_cast<int>(s));
    if (owner >= 0 && problem_.steps[s].kind == Kind::read)
      latched_[static_cast<std::size_t>(owner)].insert(problem_.steps[s].condition);
  }
  if (requirement.condition < 0) find_setters();
  for (int pass = 0; pass < most_passes; ++pass) {
    if (requirement.condition < 0) ages_.clear();  // samples on their way to conditions
    bool changed = false;
    for (std::size_t n = 0; n < begins_.size(); ++n) changed = visit(static_cast<int>(n)) || changed;
    if (!changed) return;
  }
}

Nanoseconds Knowledge::at(Pass pass) const {
  const Segment& segment = view_.forest.segment_of(view_.forest.nodes[static_cast<std::size_t>(pass.node)]);
  const auto& effects = effects_[static_cast<std::size_t>(pass.node)];
  for (std::size_t s = 0; s < segment.steps.size() && s < effects.size(); ++s) {
    if (segment.steps[s].step == pass.step) return effects[s];
  }
  return nothing;
}

void Knowledge::find_setters() {
  for (std::size_t s = 0; s < problem_.steps.size(); ++s) {
    if (problem_.steps[s].kind != Kind::set) continue;
    auto& at = set_at_[problem_.steps[s].condition];
    at.resize(problem_.steps.size());
    at[s] = true;
  }
  for (const auto& [condition, at] : set_at_) {
    for (int thread : owners(view_, at))
      setters_[condition].push_back({thread, std::make_unique<Passes>(view_, thread, at)});
  }
}

/// Follows the node's ways; true: something more is known than before.
bool Knowledge::visit(int node) {
  const auto n = static_cast<std::size_t>(node);
  const Segment& segment = view_.forest.segment_of(view_.forest.nodes[n]);
  const Beginning& begins = segment.beginning;
  State first = begin(node);
  first.known = std::max(first.known, begins_[n].known);
  first.set = std::max(first.set, begins_[n].set);
  const bool changed = first != begins_[n];
  begins_[n] = first;
  std::map<int, State> reached;
  const auto reach = [&](int step, const State& state) {
    const auto [place, fresh] = reached.emplace(step, state);
    if (fresh) return;
    place->second.known = std::min(place->second.known, state.known);
    place->second.set = std::min(place->second.set, state.set);
  };
  std::vector<Nanoseconds> effects;
  const bool after_wait = begins.kind == Beginning::Kind::arm || begins.kind == Beginning::Kind::give_up;
  if (begins.kind == Beginning::Kind::entry) {
    reach(problem_.threads[static_cast<std::size_t>(begins.thread)].entry, first);
  } else {
    const Step& step = problem_.steps[static_cast<std::size_t>(begins.step)];
    if (after_wait) effects.push_back(first.known);
    const bool arm = begins.kind == Beginning::Kind::arm;
    const bool joined = begins.kind == Beginning::Kind::joined;
    reach(joined ? step.next.front()
          : arm  ? step.next[static_cast<std::size_t>(begins.arm)]
                 : step.next.back(),
          first);
  }
  for (std::size_t s = after_wait ? 1 : 0; s < segment.steps.size(); ++s) {
    const int step = segment.steps[s].step;
    State state = reached.at(step);
    transfer(node, step, state);
    effects.push_back(state.known);
    for (int next : problem_.steps[static_cast<std::size_t>(step)].next) reach(next, state);
  }
  const bool more = changed || effects != effects_[n];
  effects_[n] = std::move(effects);
  arrivals_[n] = std::move(reached);
  return more;
}

Knowledge::State Knowledge::begin(int node) const {
  const auto n = static_cast<std::size_t>(node);
  const Node& of = view_.forest.nodes[n];
  State state;
  const auto arrived = [this](int before, int step) {
    const auto& arrivals = arrivals_[static_cast<std::size_t>(before)];
    const auto found = arrivals.find(step);
    return found == arrivals.end() ? State{} : found->second;
  };
  const auto& previous = view_.conduct.previous[n];
  if (!previous.empty()) {
    state = {never, never};
    for (int before : previous) {
      const State there = arrived(before, view_.forest.segment_of(of).beginning.step);
      state.known = std::min(state.known, there.known);
      state.set = std::min(state.set, there.set);
    }
  } else if (of.release == Release::fork && of.cause >= 0) {
    state = arrived(of.cause, of.cause_step);
  } else if (in_paced_round(view_, node)) {
    state = before_home(node);
  }
  if (of.release == Release::fork && view_.forest.segment_of(of).beginning.kind == Beginning::Kind::joined)
    state.set = std::max(state.set, set_by_blocks(of));
  // At time 0 nobody knows more, and a condition has the value that it is born with.
  if (view_.forest.sources[static_cast<std::size_t>(of.source)].kind == Source::Kind::start) {
    state.known = std::max<Nanoseconds>(state.known, 0);
    state.set = std::max<Nanoseconds>(state.set, 0);
  }
  state.known = std::max(state.known, told(node));
  return state;
}

/// Last set by the blocks that have ended when a node begins.
Nanoseconds Knowledge::set_by_blocks(const Node& joined) const {
  Nanoseconds latest = nothing;
  for (int block : problem_.steps[static_cast<std::size_t>(joined.cause_step)].threads) {
    if (!problem_.threads[static_cast<std::size_t>(block)].can_end) continue;
    Nanoseconds soonest = never;
    for (int n : view_.conduct.threads[static_cast<std::size_t>(block)].nodes) {
      const int round = view_.conduct.round[static_cast<std::size_t>(n)];
      if (view_.forest.nodes[static_cast<std::size_t>(round)].cause != joined.cause) continue;
      for (const auto& [step, state] : arrivals_[static_cast<std::size_t>(n)]) {
        if (problem_.steps[static_cast<std::size_t>(step)].kind == Kind::end)
          soonest = std::min(soonest, state.set);
      }
    }
    if (soonest < never) latest = std::max(latest, soonest);
  }
  return latest;
}

/// From the round before; the first round begins with what is younger than the skill.
Knowledge::State Knowledge::before_home(int node) const {
  const int thread = view_.forest.thread_of(node);
  const int source = paced_source(view_, thread);
  if (source < 0 || !regular_[static_cast<std::size_t>(thread)]) return {};
  const ThreadConduct& of = view_.conduct.threads[static_cast<std::size_t>(thread)];
  // Of rounds that come in several ways a later one may overtake.
  const auto ways =
      std::count_if(of.rounds.begin(), of.rounds.end(), [this](int n) { return in_paced_round(view_, n); });
  if (ways > 1) return {};
  State state{never, never};
  for (int other : of.nodes) {
    if (!in_paced_round(view_, other)) continue;
    const auto& arrivals = arrivals_[static_cast<std::size_t>(other)];
    const Segment& segment = view_.forest.segment_of(view_.forest.nodes[static_cast<std::size_t>(other)]);
    for (const Segment::Arrival& wait : segment.waits) {
      if (wait.step != of.home) continue;
      const auto found = arrivals.find(of.home);
      const State there = found == arrivals.end() ? State{} : found->second;
      state.known = std::min(state.known, there.known);
      state.set = std::min(state.set, there.set);
    }
  }
  const Nanoseconds gap = view_.times.longest_gap[static_cast<std::size_t>(source)];
  const Nanoseconds first = view_.times.first[static_cast<std::size_t>(source)];
  const auto since = [&](Nanoseconds before) {
    if (before >= never) return nothing;  // it never comes home
    return first >= never ? nothing : std::min(earlier(before, gap), -first);
  };
  return {since(state.known), since(state.set)};
}

bool Knowledge::sampled(int channel) const {
  const auto& samples = requirement_.samples;
  return std::find(samples.begin(), samples.end(), channel) != samples.end();
}

/// By the message that begins the node.
Nanoseconds Knowledge::told(int node) const {
  if (requirement_.condition >= 0) return nothing;
  const Node& of = view_.forest.nodes[static_cast<std::size_t>(node)];
  const Source& source = view_.forest.sources[static_cast<std::size_t>(of.source)];
  if (of.release == Release::message) return told_by(of.cause, of.sends, of.device);
  if (of.release != Release::root) return nothing;
  if (source.kind == Source::Kind::event) {
    const int event = problem_.devices[static_cast<std::size_t>(source.device)].event;
    return sampled(event) ? 0 : nothing;
  }
  return source.kind == Source::Kind::loop ? told_in_loop(source, of.source) : nothing;
}

/// A message carries what its sender knows; a device's answer says what was so after the request.
Nanoseconds Knowledge::told_by(int sender, const std::vector<int>& sends, int device) const {
  Nanoseconds known = never;
  for (int send : sends) {
    if (device < 0) {
      known = std::min(known, at({sender, send}));
      continue;
    }
    const int request = problem_.steps[static_cast<std::size_t>(send)].channels.front();
    const int answer = problem_.channels[static_cast<std::size_t>(request)].answer;
    known =
        std::min(known, sampled(answer) ? earliest_effect(view_.forest, view_.times, sender, send) : nothing);
  }
  return known >= never ? nothing : known;
}

/// By what leads to the next round of a loop.
Nanoseconds Knowledge::told_in_loop(const Source& source, int index) const {
  Nanoseconds known = never;
  for (const Source::Feed& feed : source.feeds) {
    if (feed.node < 0 || feed.sends.empty()) return nothing;
    const int from = view_.forest.nodes[static_cast<std::size_t>(feed.node)].source;
    const bool own = from == index;
    if (!own && view_.forest.sources[static_cast<std::size_t>(from)].kind != Source::Kind::start)
      return nothing;
    const auto& apart = own ? view_.times.longest_gap : view_.times.first;
    known = std::min(
        known, earlier(told_by(feed.node, feed.sends, feed.device), apart[static_cast<std::size_t>(index)]));
  }
  return known >= never ? nothing : known;
}

/// Whether a step surely reads a condition, or has read it before for this very test.
bool Knowledge::surely_read(int step, int condition) const {
  const Step& of = problem_.steps[static_cast<std::size_t>(step)];
  if (of.kind == Kind::read) return of.condition == condition;
  const auto thread = static_cast<std::size_t>(view_.forest.segments.owner(step));
  return tests(of, condition) && !latched_[thread].contains(condition);
}

void Knowledge::transfer(int node, int step, State& state) {
  const Step& of = problem_.steps[static_cast<std::size_t>(step)];
  const int thread = view_.forest.thread_of(node);
  const Nanoseconds now = earliest_effect(view_.forest, view_.times, node, step);
  if (requirement_.condition >= 0) {
    if (of.kind == Kind::set && of.condition == requirement_.condition) state.set = now;
    if (surely_read(step, requirement_.condition)) {
      const Nanoseconds read = earlier(now, age_when_read(requirement_.condition, thread));
      state.known = std::max({state.known, read, state.set});
    }
    return;
  }
  for (const auto& [condition, at] : set_at_) {
    if (!surely_read(step, condition)) continue;
    state.known = std::max(state.known, earlier(now, age_when_read(condition, thread)));
  }
}

Nanoseconds Knowledge::age_when_read(int condition, int reader) {
  const auto [place, fresh] = ages_.emplace(std::pair{condition, reader}, never);
  if (fresh) {
    place->second = requirement_.condition >= 0 ? value_age(view_, condition, reader).value
                                                : sample_age(condition, reader);
  }
  return place->second;
}

/// Greatest time since the sample that a condition carries when it is read. Before the first set of a round
/// it is no longer than the skill has run.
Nanoseconds Knowledge::sample_age(int condition, int reader) const {
  const auto found = setters_.find(condition);
  if (found == setters_.end()) return never;
  Nanoseconds at_set = 0;     // age of the sample at any set
  Nanoseconds apart = never;  // sets
  Nanoseconds until_first = never;
  Nanoseconds together = never;  // both, of the one setter
  bool later = false;            // sets that are neither in rounds nor at the start
  for (const Setter& setter : found->second) {
    const Passes& sets = *setter.sets;
    const auto age = [&](Pass pass) {
      const Nanoseconds known = at(pass);
      const Nanoseconds latest = latest_effect(view_.forest, view_.times, pass.node, pass.step);
      return known <= nothing || latest >= never ? never : latest - known;
    };
    Nanoseconds soonest = never;
    Nanoseconds known = never;
    for (const Pass& pass : sets.in_rounds()) {
      soonest = std::min(soonest, earliest_effect(view_.forest, view_.times, pass.node, pass.step));
      known = std::min(known, at(pass));
      at_set = std::max(at_set, age(pass));
    }
    for (const Pass& pass : sets.before_rounds()) {
      const int source = view_.forest.nodes[static_cast<std::size_t>(pass.node)].source;
      later = later || view_.forest.sources[static_cast<std::size_t>(source)].kind != Source::Kind::start;
      at_set = std::max(at_set, age(pass));
    }
    if (!sets.every_round() || sets.in_rounds().empty() || !outlasts(view_, setter.thread, reader)) continue;
    const Nanoseconds next = plus(sets.gap(), sets.latest());
    until_first = std::min(until_first, plus(sets.first(), sets.latest()));
    if (next < never) apart = std::min(apart, next - soonest);
    if (next < never && known > nothing) together = next - known;
  }
  if (found->second.size() > 1 || later) together = plus(apart, at_set);
  return std::max(together, until_first);
}

}  // namespace pal::analyzer::compositional
