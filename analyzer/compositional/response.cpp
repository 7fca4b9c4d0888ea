// How long an event waits for its answer.
#include <algorithm>

#include "analyzer/compositional/ground.hpp"
#include "analyzer/compositional/measures.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;
using Release = Node::Release;

/// Follows the event from thread to thread, as far as every run must carry it: until it is answered, or the
/// skill has ended.
class Pursuit {
 public:
  Pursuit(const View& view, const Requirement& requirement)
      : view_(view), problem_(view.problem), requirement_(requirement) {}

  Bound run() {
    const int source = source_of();
    if (source < 0) return unknown("the event is none of a device");
    const Source& of = view_.forest.sources[static_cast<std::size_t>(source)];
    const std::string& device = problem_.devices[static_cast<std::size_t>(of.device)].name;
    if (of.roots.empty()) return unknown("nobody waits for events of " + device);
    if (!view_.times.no_overrun[static_cast<std::size_t>(source)]) {
      const std::string trouble = trouble_of(of.roots.front());
      return unknown(trouble.empty() ? "an event of " + device + " may come before the last one was taken"
                                     : trouble);
    }
    const Sum answer = node_value(of.roots.front());
    if (!answer.bounded()) return unknown(why_.empty() ? "an event may stay without a response" : why_);
    const Nanoseconds apart = of.period - of.jitter;
    if ((answer.value() >= apart || view_.steady) && !in_order(source))
      return unknown("an event may be answered after the next one has come, by another way");
    return {greater(Sum(), answer), ""};
  }

  /// Whether each occurrence of a source leads to a statement, in whatever round.
  bool always_comes(int source) {
    const Source& of = view_.forest.sources[static_cast<std::size_t>(source)];
    return std::any_of(of.roots.begin(), of.roots.end(),
                       [this](int root) { return node_value(root).bounded(); });
  }

  /// Whether each event of the device is taken before the next one comes.
  Bound losses() {
    const int source = source_of();
    if (source < 0) return unknown("nobody waits for its events");
    const Source& of = view_.forest.sources[static_cast<std::size_t>(source)];
    const bool none = !of.roots.empty() && view_.times.no_overrun[static_cast<std::size_t>(source)] &&
                      certain(of.roots.front());
    if (none) return {Sum(), ""};
    return unknown(why_.empty() ? "an event may come before the last one was taken" : why_);
  }

 private:
  static Bound unknown(std::string why) { return {Sum::unbounded(), std::move(why)}; }
  /// No way leads from here to an answer, nor to anything else.
  static Sum no_way() { return Sum::number(-1); }

  const Node& node(int n) const { return view_.forest.nodes[static_cast<std::size_t>(n)]; }
  const Segment& segment(int n) const { return view_.forest.segment_of(node(n)); }
  const Step& step_at(int step) const { return problem_.steps[static_cast<std::size_t>(step)]; }

  int source_of() const {
    for (std::size_t s = 0; s < view_.forest.sources.size(); ++s) {
      const Source& of = view_.forest.sources[s];
      if (of.kind == Source::Kind::event && of.device == requirement_.device) return static_cast<int>(s);
    }
    return -1;
  }

  std::string trouble_of(int n) const {
    return view_.times.trouble[static_cast<std::size_t>(view_.forest.thread_of(n))];
  }

  bool certain(int n) {
    const auto thread = static_cast<std::size_t>(view_.forest.thread_of(n));
    // A device is closed until somebody waits for its event.
    const bool opens = node(view_.conduct.round[static_cast<std::size_t>(n)]).release == Release::root;
    if (view_.lasts(static_cast<int>(thread)) && (view_.begun[thread] || opens)) return true;
    // A block that the event itself starts, and that ends.
    const Thread& block = problem_.threads[thread];
    const bool started = node(view_.conduct.round[static_cast<std::size_t>(n)]).release == Release::fork;
    if (started && block.can_end && view_.lively[thread] &&
        !view_.conduct.threads[static_cast<std::size_t>(block.parent)].may_be_cancelled) {
      return true;
    }
    if (why_.empty()) {
      why_ = view_.times.trouble[thread];
      if (why_.empty()) why_ = problem_.threads[thread].name + " may leave its round, or wait in it for ever";
    }
    return false;
  }

  /// Latest answer of an event whose message begins this node.
  Sum node_value(int n) {
    const auto known = nodes_.find(n);
    if (known != nodes_.end()) return known->second;
    Sum value = Sum::unbounded();
    if (certain(n)) {
      value = beginning_value(n);
      if (!value.bounded() && why_.empty()) why_ = trouble_of(n);
    }
    nodes_[n] = value;
    return value;
  }

  Sum beginning_value(int n) {
    const Beginning& begins = segment(n).beginning;
    if (begins.kind == Beginning::Kind::entry)
      return step_value(n, problem_.threads[static_cast<std::size_t>(begins.thread)].entry);
    const Step& step = step_at(begins.step);
    if (begins.kind == Beginning::Kind::joined) return step_value(n, step.next.front());
    if (requirement_.at[static_cast<std::size_t>(begins.step)]) return since_event(view_, n, begins.step);
    const bool gives_up = begins.kind == Beginning::Kind::give_up;
    return step_value(n, gives_up ? step.next.back() : step.next[static_cast<std::size_t>(begins.arm)]);
  }

  Sum step_value(int n, int at) {
    const auto known = steps_.find({n, at});
    if (known != steps_.end()) return known->second;
    const Step& step = step_at(at);
    Sum value = Sum::unbounded();
    if (step.kind == Kind::wait) {
      value = wait_value(n, at);
    } else if (step.kind == Kind::fork) {
      const bool reached = requirement_.at[static_cast<std::size_t>(at)];
      value = reached ? finish_since_event(view_, n) : fork_value(n, at);
    } else if (requirement_.at[static_cast<std::size_t>(at)] || step.kind == Kind::complete) {
      value = since_event(view_, n, at);
    } else if (step.kind != Kind::end) {
      value = may_match_nothing(step) ? since_event(view_, n, at) : no_way();
      for (int next : step.next) value = greater(value, step_value(n, next));
      if (step.kind == Kind::send) value = less(value, sent_value(n, at));
    }
    steps_[{n, at}] = value;
    return value;
  }

  /// Of a message that carries the event to the one thread that takes it.
  Sum sent_value(int n, int send) {
    const int channel = step_at(send).channels.front();
    if (problem_.channels[static_cast<std::size_t>(channel)].answer >= 0 && may_give_up(problem_, channel)) {
      if (why_.empty()) why_ = "a request may be withdrawn before it is taken";
      return Sum::unbounded();
    }
    int taker = -1;
    for (int effect : node(n).effects) {
      const auto& sends = node(effect).sends;
      if (std::find(sends.begin(), sends.end(), send) == sends.end()) continue;
      if (taker >= 0 || node(effect).release != Release::message) return Sum::unbounded();
      taker = effect;
    }
    if (taker < 0 || view_.forest.thread_of(taker) == view_.forest.thread_of(n)) return Sum::unbounded();
    // What comes back to a thread in the middle of its round is followed there.
    if (!view_.conduct.previous[static_cast<std::size_t>(taker)].empty()) return Sum::unbounded();
    return node_value(taker);
  }

  /// Each block carries the event, as does its parent when they are over.
  Sum fork_value(int n, int fork) {
    Sum value = Sum::unbounded();
    for (int effect : node(n).effects) {
      if (node(effect).release == Release::fork && node(effect).cause_step == fork)
        value = less(value, node_value(effect));
    }
    return value;
  }

  Sum wait_value(int n, int wait) {
    const int thread = view_.forest.thread_of(n);
    if (wait == view_.conduct.threads[static_cast<std::size_t>(thread)].home) return Sum::unbounded();
    Sum value = no_way();
    bool any = false;
    for (int other : view_.conduct.threads[static_cast<std::size_t>(thread)].nodes) {
      const auto& previous = view_.conduct.previous[static_cast<std::size_t>(other)];
      if (segment(other).beginning.step != wait ||
          std::find(previous.begin(), previous.end(), n) == previous.end())
        continue;
      any = true;
      value = greater(value, node_value(other));
    }
    return any ? value : Sum::unbounded();
  }

  /// Whether events cannot overtake one another although several are on their way: every thread that they
  /// meet serves them alone, in one round each, and one thread answers.
  bool in_order(int source) const {
    std::set<int> answering;
    for (std::size_t i = 0; i < view_.forest.nodes.size(); ++i) {
      if (view_.forest.nodes[i].source != source) continue;
      const int n = static_cast<int>(i);
      const int thread = view_.forest.thread_of(n);
      if (view_.conduct.threads[static_cast<std::size_t>(thread)].rounds.size() != 1) return false;
      for (const Segment::Passed& passed : segment(n).steps) {
        if (requirement_.at[static_cast<std::size_t>(passed.step)]) answering.insert(thread);
      }
    }
    return answering.size() == 1;
  }

  const View& view_;
  const Problem& problem_;
  const Requirement& requirement_;
  std::map<int, Sum> nodes_;
  std::map<std::pair<int, int>, Sum> steps_;
  std::string why_;
};

}  // namespace

Bound response_bound(const View& view, const Requirement& requirement) {
  return Pursuit(view, requirement).run();
}

bool always_comes(const View& view, int source, const std::vector<bool>& at) {
  Requirement comes;
  comes.measure = Requirement::Measure::response;
  comes.at = at;
  return Pursuit(view, comes).always_comes(source);
}

Bound event_loss_bound(const View& view, const Requirement& requirement) {
  return Pursuit(view, requirement).losses();
}

}  // namespace pal::analyzer::compositional
