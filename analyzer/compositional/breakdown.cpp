#include "analyzer/compositional/breakdown.hpp"

#include <algorithm>
#include <utility>

#include "analyzer/compositional/times/joint_chain.hpp"
#include "analyzer/compositional/times/release.hpp"
#include "analyzer/compositional/times/slots.hpp"

namespace pal::analyzer::compositional {
namespace {

using By = Due::By;

constexpr std::size_t most_addends = 400;

/// Follows latest instants back to where their sources begin.
class Writer {
 public:
  explicit Writer(const View& view)
      : view_(view),
        context_{view.problem, view.forest, view.behaviours},
        nominal_{view.times.nodes, {context_, view.times.nodes, *view.times.interference}, Since::occurrence},
        since_event_{view.times.since_event,
                     {context_, view.times.since_event, view.times.nodes, *view.times.interference},
                     Since::release},
        since_cause_(view.times.interference->since_cause()) {}

  std::vector<Addend> run(const Sum& bound) {
    for (const Sum::Addend& each : bound.addends()) add(each);
    if (out_.size() > most_addends) out_.clear();
    return std::move(out_);
  }

 private:
  /// What instants count from: the nominal instants of their sources, or the events themselves.
  struct Clock {
    const Table<NodeId, NodeTimes>& nodes;
    Releases releases;
    Since since;  // what the ends of segments count from

    const NodeTimes& times(NodeId node) const { return nodes[node]; }
  };

  void say(Nanoseconds amount, const std::string& actor, std::string what, StatementId statement = {}) {
    if (amount == 0) return;
    Addend made{amount, actor, std::move(what), "", 0, {}};
    if (statement.valid()) {
      const Statement& of = view_.problem.statements[statement];
      made.file = of.file;
      made.line = of.line;
    }
    out_.push_back(std::move(made));
  }

  const std::string& thread_name(ThreadId thread) const { return context_.thread_at(thread).name; }
  const std::string& actor(NodeId node) const { return thread_name(view_.forest.thread_of(node)); }

  std::string text(StepId step) const {
    const StatementId statement = context_.step_at(step).statement;
    return !statement.valid() ? "a test" : view_.problem.statements[statement].text;
  }

  /// Where a node begins, in the text.
  StatementId statement_of(NodeId node) const {
    const Segment& of = context_.segment(node);
    for (const Segment::Passed& passed : of.steps) {
      const StatementId statement = context_.step_at(passed.step).statement;
      if (statement.valid()) return statement;
    }
    return StatementId{};
  }

  void add(const Sum::Addend& each) {
    const Term& term = each.term;
    switch (term.kind) {
      case Term::Kind::latest:
      case Term::Kind::since_event: {
        const Clock& clock = term.kind == Term::Kind::latest ? nominal_ : since_event_;
        if (each.amount == instant(clock, term)) return until(clock, term.node, term.step);
        return say(each.amount, actor(term.node), "at the latest, until " + place(term), statement(term));
      }
      case Term::Kind::since_cause: {
        const NodeId cause = std::exchange(from_, term.cause);
        if (each.amount == instant(nominal_, term) - begun()) {
          until(nominal_, term.node, term.step);
        } else {
          say(each.amount, actor(term.node), "at the latest, until " + place(term), statement(term));
        }
        from_ = cause;
        return;
      }
      case Term::Kind::earliest:
        return say(each.amount, actor(term.node), "at the earliest, until " + place(term), statement(term));
      case Term::Kind::release:
        if (each.amount == nominal_.times(term.node).latest) return release(nominal_, term.node);
        return say(each.amount, actor(term.node), "begins at the latest", statement_of(term.node));
      case Term::Kind::gap:
        return inter_arrival(term.source, view_.times.longest_gap[term.source], each.amount, false);
      case Term::Kind::first:
        return inter_arrival(term.source, view_.times.first[term.source], each.amount, true);
      case Term::Kind::said:
        if (term.node.valid()) return say(each.amount, actor(term.node), term.what, statement(term));
        return say(each.amount, !term.source.valid() ? "" : source_name(term.source), term.what);
    }
  }

  /// To a source's next occurrence, or the first.
  void inter_arrival(SourceId source, const Due& next, Nanoseconds amount, bool first) {
    const Source& of = view_.forest.sources[source];
    const std::string& name = source_name(source);
    if (of.kind == Source::Kind::event) {
      say(amount - next.after, name, "has no thread that waits for it yet");
      return say(next.after, name, first ? "comes for the first time" : "comes again");
    }
    if (amount != next.at || !next.node.valid())
      return say(amount, name, first ? "comes to its first job" : "comes to its next job");
    wait_for(nominal_, next, name, feed_device(of, next));
  }

  static DeviceId feed_device(const Source& of, const Due& next) {
    for (const Source::Feed& feed : of.feeds) {
      if (feed.node == next.node && std::count(feed.sends.begin(), feed.sends.end(), next.step) > 0)
        return feed.device;
    }
    return DeviceId{};
  }

  /// `name` waits for an arrival, or for what was sent.
  void wait_for(const Clock& clock, const Due& due, const std::string& name, DeviceId device) {
    const StatementId statement = context_.step_at(due.step).statement;
    if (due.by == By::arrival) {
      until_arrival(clock, due.node, due.step);
      return say(due.after, name, "waits at " + text(due.step), statement);
    }
    if (due.by == By::put) return until_put(clock, due.node, due.step);
    until(clock, due.node, due.step);
    if (!device.valid())
      return say(due.after, name, "waits until " + text(due.step) + " has arrived", statement);
    say(due.after, view_.problem.devices[device].name, "answers " + text(due.step), statement);
  }

  Nanoseconds instant(const Clock& clock, const Term& term) const {
    return !term.step.valid() ? clock.times(term.node).finish
                              : latest_effect(view_.forest, clock.nodes, term.node, term.step);
  }
  std::string place(const Term& term) const {
    return !term.step.valid() ? "the end of the segment" : text(term.step) + " has its effect";
  }
  StatementId statement(const Term& term) const {
    return !term.step.valid() ? statement_of(term.node) : context_.step_at(term.step).statement;
  }

  std::string source_name(SourceId source) const {
    const Source& of = view_.forest.sources[source];
    return of.kind == Source::Kind::event ? view_.problem.devices[of.device].name : thread_name(of.thread);
  }

  /// To the latest effect of a step of a node, or to the end of its segment.
  void until(const Clock& clock, NodeId node, StepId step) {
    const Segment& of = context_.segment(node);
    if (!step.valid()) {
      return work(clock, node, of.worst, StepId{}, [](const NodeTimes& times) { return times.finish; });
    }
    const std::size_t at = place_of(of, step);
    work(clock, node, of.steps[at].worst, step, [at](const NodeTimes& times) { return times.effects[at]; });
  }

  /// To where a step puts, or waits for its slot.
  void until_put(const Clock& clock, NodeId node, StepId step) {
    const Segment& of = context_.segment(node);
    const std::size_t at = place_of(of, step);
    work(clock, node, of.steps[at].worst, step, [at](const NodeTimes& times) { return times.worked[at]; });
  }

  /// To the latest arrival at a wait or CONCURRENT.
  void until_arrival(const Clock& clock, NodeId node, StepId step) {
    const Segment& of = context_.segment(node);
    for (std::size_t w = 0; w < of.waits.size(); ++w) {
      if (of.waits[w].step != step) continue;
      return work(clock, node, of.waits[w].worst, step,
                  [w](const NodeTimes& times) { return times.arrivals[w]; });
    }
    work(clock, node, of.worst, StepId{}, [](const NodeTimes& times) { return times.finish; });
  }

  /// To when `part` of the node's work is done, at the instant `done_of` its times; it ends with `step`.
  template <class DoneOf>
  void work(const Clock& asked, NodeId node, Nanoseconds part, StepId step, const DoneOf& done_of) {
    if (out_.size() > most_addends) return;
    const Nanoseconds done = done_of(asked.times(node));
    // What is no later after the event than after its nominal instant is followed from there.
    const Clock& clock = done == done_of(nominal_.times(node)) ? nominal_ : asked;
    const Nanoseconds released = clock.times(node).latest;
    if (clock.since == Since::release && !ends_by_window(clock, node, part, done) &&
        together(clock, node, part, done, step))
      return;
    release(clock, node);
    if (done == released) return;
    if (ends_by_window(clock, node, part, done)) {
      window(clock, node, part);
      return actions(node, part, step);
    }
    // A send waits for its slot.
    const bool sends = step.valid() && context_.step_at(step).kind == Step::Kind::send;
    say(done - released, actor(node), sends ? "is blocked at " + text(step) : "is blocked in its last send",
        !step.valid() ? StatementId{} : context_.step_at(step).statement);
  }

  /// If `done` is when a chain of segments in one window is done: to that instant.
  bool together(const Clock& clock, NodeId node, Nanoseconds part, Nanoseconds done, StepId step) {
    const auto released = [&clock](NodeId n) { return clock.times(n).latest; };
    const JointEnd joint = soonest_joint_end(*view_.times.interference,
                                             joint_chain(context_, view_.times, node), part, released);
    if (joint.chain.empty() || plus(released(joint.chain.front()), joint.after) != done) return false;
    release(clock, joint.chain.front());
    others(node, view_.times.interference->joint_breakdown(joint.chain, part));
    for (NodeId each : joint.chain) {
      if (each != node) actions(each, context_.segment(each).worst, StepId{});
    }
    actions(node, part, step);
    return true;
  }

  bool ends_by_window(const Clock& clock, NodeId node, Nanoseconds part, Nanoseconds done) const {
    const Interference& interference = *view_.times.interference;
    const Nanoseconds end = interference.finish(node, part, interference.blocking(node), clock.since);
    return done == (clock.since == Since::release ? plus(clock.times(node).latest, end) : end);
  }

  /// What keeps the node from its processor.
  void window(const Clock& clock, NodeId node, Nanoseconds part) {
    const FinishBreakdown breakdown = view_.times.interference->breakdown(node, part, clock.since);
    if (out_.size() + breakdown.others.size() > most_addends) return out_.resize(most_addends + 1);
    const std::string& name = actor(node);
    if (breakdown.blocking > 0) {
      const ThreadId thread = view_.times.interference->blocking_thread(node);
      say(breakdown.blocking, name,
          "is kept from its processor by " + thread_name(thread) + ", which cannot be preempted");
    }
    others(node, breakdown.others);
    say(-breakdown.done_before, name, "of all that, so much is over before it is released");
  }

  /// The work that keeps the node from its processor.
  void others(NodeId node, const std::vector<Share>& shares) {
    if (out_.size() + shares.size() > most_addends) return out_.resize(most_addends + 1);
    const std::string& name = actor(node);
    for (const Share& share : shares) {
      const NodeId other = view_.times.interference->node_of(share.transaction, share.task);
      const std::string times = share.jobs == 1 ? "" : ", " + std::to_string(share.jobs) + " times";
      const bool itself = view_.forest.thread_of(other) == view_.forest.thread_of(node);
      say(share.work, name,
          (itself ? "does other work first" : "is kept from its processor by " + actor(other)) + times,
          statement_of(other));
    }
  }

  /// The actions on the longest way to `part` of the node's work.
  void actions(NodeId node, Nanoseconds part, StepId step) {
    const Segment& of = context_.segment(node);
    std::vector<StepId> way;
    Nanoseconds left = part;
    StepId next = step;
    for (std::size_t s = of.steps.size(); s-- > 0 && left > 0;) {
      const Segment::Passed& passed = of.steps[s];
      const std::vector<StepId>& after = context_.step_at(passed.step).next;
      const bool leads =
          way.empty() && (!next.valid() || passed.step == next)
              ? true
              : std::find(after.begin(), after.end(), next) != after.end() || begins_with(of, s);
      if (!leads || passed.worst != left) continue;
      way.push_back(passed.step);
      left -= own(of, s);
      next = passed.step;
    }
    const std::string& name = actor(node);
    for (std::size_t w = way.size(); w-- > 0;) {
      const Nanoseconds cost = own(of, place_of(of, way[w]));
      say(cost, name, "runs " + text(way[w]), context_.step_at(way[w]).statement);
      part -= cost;
    }
    say(part, name, "runs", statement_of(node));
  }

  /// Whether a segment's place is that of the wait that begins it.
  static bool begins_with(const Segment& of, std::size_t place) {
    return place == 0 && of.steps.front().step == of.beginning.step;
  }
  /// Processor time of a step on its segment.
  Nanoseconds own(const Segment& of, std::size_t place) const {
    return begins_with(of, place) ? of.steps[place].worst : context_.step_at(of.steps[place].step).cost.worst;
  }

  /// When the cause from which instants count is released at the latest.
  Nanoseconds begun() const { return !from_.valid() ? 0 : nominal_.times(from_).latest; }

  /// To the latest release of a node.
  void release(const Clock& asked, NodeId node) {
    if (node == from_) return;
    const Nanoseconds latest_at = asked.times(node).latest;
    const Clock& clock = latest_at == nominal_.times(node).latest ? nominal_ : asked;
    const Due latest = clock.releases.latest(node, view_.times.unbounded_reason, view_.times.blocked);
    const Node& of = context_.node(node);
    const std::string& name = actor(node);
    const Nanoseconds at = latest_at - begun();
    const bool before = from_.valid() && !since_cause_.counts_from(from_, node);
    if (latest.at != latest_at || before || deep_ > 200)
      return say(at, name, "begins so late", statement_of(node));
    ++deep_;
    switch (latest.by) {
      case By::source:
        say(latest.after, source_name(of.source), "comes so late");
        break;
      case By::held:
        say(at, name, "was blocked in its previous job");
        break;
      case By::idle:
        say(at, name, "comes to its first wait");
        break;
      case By::blocks:
        say(at, name, "waits for its blocks", context_.step_at(latest.step).statement);
        break;
      case By::arrival:
      case By::message:
      case By::put:
        wait_for(clock, latest, name, of.device);
        break;
    }
    --deep_;
  }

  const View& view_;
  AnalysisContext context_;
  Clock nominal_;
  Clock since_event_;
  SinceCause since_cause_;
  NodeId from_{};  // the node from whose release instants count; -1: the nominal instant of their source
  std::vector<Addend> out_;
  int deep_ = 0;
};

}  // namespace

std::vector<Addend> breakdown_of(const View& view, const Sum& bound) {
  return Writer(view).run(bound);
}

}  // namespace pal::analyzer::compositional
