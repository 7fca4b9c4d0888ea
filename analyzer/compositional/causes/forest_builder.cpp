// Builds the forest of causes: each source, and whatever it triggers, until nothing new is triggered.
#include "analyzer/compositional/causes/forest.hpp"

#include <algorithm>

#include "analyzer/compositional/causes/job_distance.hpp"
#include "analyzer/compositional/causes/refusal.hpp"
#include "analyzer/compositional/causes/sequence.hpp"
#include "analyzer/compositional/causes/takers.hpp"
#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;

class ForestBuilder {
 public:
  ForestBuilder(const Problem& problem, Forest& forest, const std::function<bool()>& stop)
      : problem_(problem),
        forest_(forest),
        stop_(stop),
        sequence_(problem),
        takers_(problem, forest.segments) {
    most_nodes_ = 40 * problem.steps.size() + 4'000;
  }

  void plant() {
    forest_.refusal = refusal_of(problem_, forest_.segments, stop_, forest_.set_aside);
    if (forest_.refusal.empty()) find_limited();
    if (!forest_.refusal.empty()) return;
    for (int attempt = 0; attempt < 60; ++attempt) {
      forest_.nodes.clear();
      planted_.clear();
      forest_.sources.clear();
      const std::size_t before = cuts_.size();
      found_.clear();
      sources();
      for (const SourceId s : forest_.sources.ids()) {
        if (forest_.refusal.empty()) grow(s);
      }
      if (!forest_.refusal.empty()) return;
      cuts_.insert(found_.begin(), found_.end());
      if (cuts_.size() == before) return;
    }
    forest_.refusal = why(Withheld::too_many_circles);
  }

 private:
  const Step& step_at(StepId step) const { return problem_.steps[step]; }
  Node& node(NodeId index) { return forest_.nodes[index]; }

  /// Nothing more is looked at: it is refused, or it was stopped, and is refused for that.
  bool is_over() {
    if (forest_.refusal.empty() && stop_ && stop_()) forest_.refusal = why(Withheld::interrupted);
    return !forest_.refusal.empty();
  }

  void find_limited() {
    limited_.assign(problem_.steps.size(), false);
    for (const StepId s : problem_.steps.ids()) {
      const Step& step = problem_.steps[s];
      if (step.kind != Kind::wait || !step.within || !forest_.segments.owner(s).valid()) continue;
      if (is_over()) return;
      limited_[s] = !loops_by_limits(s);
    }
  }

  /// Whether the thread can come back to a wait by way of waits with limits alone.
  bool loops_by_limits(StepId wait) const {
    return follow(problem_, step_at(wait).next, [&](StepId at) {
      if (at == wait) return Course::found;
      return step_at(at).kind == Kind::wait && !step_at(at).within ? Course::ends : Course::goes_on;
    });
  }

  void sources() {
    for (const DeviceId d : problem_.devices.ids()) {
      const auto* event = std::get_if<pan::EventDevice>(&problem_.devices[d].behaviour);
      if (event == nullptr || !problem_.devices[d].event.valid()) continue;
      Source source;
      source.kind = Source::Kind::event;
      source.device = d;
      source.period = event->period.count();
      source.jitter = event->jitter.count();
      source.regular = !event->sporadic;
      forest_.sources.push_back(source);
    }
    for (const ThreadId t : problem_.threads.ids()) {
      if (problem_.threads[t].parent.valid()) continue;
      Source source;
      source.thread = t;
      source.period = never;
      forest_.sources.push_back(source);
    }
    for (const StepId s : problem_.steps.ids()) {
      const ThreadId thread = forest_.segments.owner(s);
      if (!thread.valid() || !begins_anew(s)) continue;
      Source source;
      source.kind = Source::Kind::joined;
      source.thread = thread;
      source.fork = s;
      source.period = never;
      forest_.sources.push_back(source);
    }
    for (SegmentId segment : cuts_) {
      Source source;
      source.kind = Source::Kind::loop;
      source.segment = segment;
      source.thread = forest_.segments[segment].beginning.thread;
      source.period = least_job_distance(problem_, forest_.segments[segment].beginning);
      if (source.period == 0)
        forest_.refusal = why(Withheld::no_least_time, problem_.threads[source.thread].name);
      forest_.sources.push_back(source);
    }
  }

  void grow(SourceId source) {
    const Source& of = forest_.sources[source];
    switch (of.kind) {
      case Source::Kind::event:
        message({source, NodeId{}, Node::Release::root, StepId{}, {}, DeviceId{}},
                problem_.devices[of.device].event);
        break;
      case Source::Kind::start:
        effect({source, NodeId{}, Node::Release::root, StepId{}, {}, DeviceId{}},
               {Beginning::Kind::entry, of.thread, StepId{}, -1});
        break;
      case Source::Kind::joined:
        effect({source, NodeId{}, Node::Release::root, StepId{}, {}, DeviceId{}},
               {Beginning::Kind::joined, of.thread, of.fork, -1});
        break;
      case Source::Kind::loop:
        add({source, NodeId{}, Node::Release::root, StepId{}, {}, DeviceId{}}, of.segment);
        break;
    }
    while (!open_.empty() && !is_over()) {
      const NodeId at = open_.back();
      open_.pop_back();
      add_effects(at);
    }
    open_.clear();
  }

  /// How something comes about.
  struct Link {
    SourceId source;
    NodeId cause;
    Node::Release release;
    StepId step;  // wait or fork
    std::vector<StepId> sends;
    DeviceId device;
  };

  void add_effects(NodeId at) {
    const Segment segment = forest_.segments[node(at).segment];
    const SourceId source = node(at).source;
    for (const std::vector<StepId>& sends : alternatives(node(at).segment)) {
      if (is_over()) return;
      const ChannelId channel = step_at(sends.front()).channels.front();
      const Channel& of = problem_.channels[channel];
      if (!of.receiver_device.valid()) {
        message({source, at, Node::Release::message, StepId{}, sends, DeviceId{}}, channel);
      } else if (of.served && of.answer.valid()) {
        message({source, at, Node::Release::message, StepId{}, sends, of.receiver_device}, of.answer);
      }
    }
    for (const Segment::Arrival& wait : segment.waits) {
      const Step& step = step_at(wait.step);
      if (is_over()) return;
      if (!step.within) continue;
      const ThreadId thread = segment.beginning.thread;
      const Link link{source, at, Node::Release::limit, wait.step, {}, DeviceId{}};
      effect(link, {Beginning::Kind::give_up, thread, wait.step, -1});
      if (!limited_[wait.step]) continue;
      for (std::size_t arm = 0; arm < step.channels.size(); ++arm) {
        effect(link, {Beginning::Kind::arm, thread, wait.step, static_cast<int>(arm)});
      }
    }
    for (const Segment::Arrival& fork : segment.forks) {
      const Link link{source, at, Node::Release::fork, fork.step, {}, DeviceId{}};
      for (ThreadId block : step_at(fork.step).threads)
        effect(link, {Beginning::Kind::entry, block, StepId{}, -1});
      const std::vector<ThreadId>& blocks = step_at(fork.step).threads;
      const bool goes_on = std::any_of(blocks.begin(), blocks.end(),
                                       [this](ThreadId block) { return problem_.threads[block].can_end; });
      if (goes_on && !begins_anew(fork.step))
        effect(link, {Beginning::Kind::joined, segment.beginning.thread, fork.step, -1});
    }
  }

  /// What comes after a CONCURRENT, once in a skill's life, if one of its blocks ends in an unknown job.
  bool begins_anew(StepId fork) const {
    const Step& step = step_at(fork);
    if (step.kind != Kind::fork) return false;
    return std::any_of(step.threads.begin(), step.threads.end(), [this](ThreadId block) {
      return problem_.threads[block].can_end && !ends_straight(problem_, block);
    });
  }

  /// The segment's sends, those of one channel together if a run passes only one of them.
  const std::vector<std::vector<StepId>>& alternatives(SegmentId index) {
    const auto [known, fresh] = alternatives_.emplace(index, std::vector<std::vector<StepId>>());
    std::vector<std::vector<StepId>>& all = known->second;
    if (!fresh) return all;
    const Segment& segment = forest_.segments[index];
    std::map<ChannelId, std::vector<StepId>> by_channel;
    for (const Segment::Passed& passed : segment.steps) {
      const Step& step = step_at(passed.step);
      if (step.kind == Kind::send) by_channel[step.channels.front()].push_back(passed.step);
    }
    for (auto& [channel, sends] : by_channel) {
      if (is_over()) return all;
      if (!any_in_row(problem_, segment, sends)) {
        all.push_back(std::move(sends));
      } else {
        for (StepId send : sends) all.push_back({send});
      }
    }
    return all;
  }

  void message(const Link& link, ChannelId channel) {
    const std::optional<std::set<StepId>> known = takers_of(link, channel);
    for (const Taker& taker : takers_.of(channel)) {
      if (known && !known->contains(taker.step)) continue;
      // Such waits are counted by their own threads' jobs.
      if (limited_[taker.step]) continue;
      effect(link, {Beginning::Kind::arm, taker.thread, taker.step, taker.arm});
    }
  }

  /// The waits that may take an answer: those that come after its request, if it is known which that is.
  std::optional<std::set<StepId>> takers_of(const Link& link, ChannelId channel) {
    const ChannelId request = problem_.channels[channel].answers;
    if (!request.valid()) return {};
    if (link.device.valid()) return takers_.after(link.sends);
    for (NodeId at = link.cause; at.valid(); at = node(at).cause) {
      const Beginning& begins = forest_.segment_of(node(at)).beginning;
      const bool asked = begins.kind == Beginning::Kind::arm && node(at).release == Node::Release::message &&
                         !node(at).device.valid() &&
                         step_at(begins.step).channels[static_cast<std::size_t>(begins.arm)] == request;
      if (!asked) continue;
      // Between the two its module may have taken another request elsewhere, and answer that.
      if (!takers_.last_taken_at(link.sends, request, begins.step)) return {};
      return takers_.after(node(at).sends);
    }
    return {};
  }

  /// Whether a segment may begin after all that leads to it.
  bool may_follow(const Link& link, const Beginning& beginning) {
    for (NodeId at = link.cause; at.valid(); at = node(at).cause) {
      if (!sequence_.may_follow(forest_.segment_of(node(at)).beginning, beginning)) return false;
    }
    return true;
  }

  void effect(const Link& link, const Beginning& beginning) {
    if (!may_follow(link, beginning)) return;
    const SegmentId segment = forest_.segments.find(beginning);
    if (forest_.segments[segment].spins) {
      forest_.refusal = why(Withheld::spins, problem_.threads[beginning.thread].name);
      return;
    }
    if (cuts_.contains(segment)) {
      for (Source& loop : forest_.sources) {
        if (loop.kind == Source::Kind::loop && loop.segment == segment) {
          loop.feeds.push_back({link.cause, link.sends, link.step, link.device});
        }
      }
      return;
    }
    const bool again = comes_again(segment);
    std::vector<NodeId> circle;
    for (NodeId at = link.cause; at.valid(); at = node(at).cause) {
      // A way through something that comes once in a skill's life is no circle.
      if (again && !comes_again(node(at).segment)) break;
      circle.push_back(at);
      if (node(at).segment != segment) continue;
      if (again && is_asked_anew(circle)) break;
      if (again) found_.insert(cut(circle));
      return;
    }
    add(link, segment);
  }

  void add(const Link& link, SegmentId segment) {
    if (forest_.nodes.size() >= most_nodes_) {
      forest_.refusal = why(Withheld::too_many_ways);
      return;
    }
    Node made;
    made.release = link.release;
    made.segment = segment;
    made.source = link.source;
    made.cause = link.cause;
    made.cause_step = link.step;
    made.sends = link.sends;
    made.device = link.device;
    made.depth = !link.cause.valid() ? 0 : node(link.cause).depth + 1 + (link.device.valid() ? 1 : 0);
    const NodeId index = forest_.nodes.push_back(made);
    if (link.cause.valid()) {
      node(link.cause).effects.push_back(index);
    } else {
      forest_.sources[link.source].roots.push_back(index);
    }
    open_.push_back(index);
    ++planted_[segment];
  }

  bool comes_again(SegmentId segment) {
    const auto [place, fresh] = comes_again_.emplace(segment, false);
    if (fresh) place->second = recurrent(problem_, forest_.segments[segment].beginning);
    return place->second;
  }

  bool takes_request(NodeId index) const {
    const Beginning& begins = forest_.segment_of(forest_.nodes[index]).beginning;
    if (begins.kind != Beginning::Kind::arm) return false;
    const ChannelId channel = step_at(begins.step).channels[static_cast<std::size_t>(begins.arm)];
    return problem_.channels[channel].answer.valid();
  }

  /// Whether a circle leads back to a server that is asked once more. If that goes on for ever, the
  /// asking is a circle, too, and is found there. Ways that part and ask multiply: not too often.
  bool is_asked_anew(const std::vector<NodeId>& circle) {
    constexpr int most_askings = 128;
    return takes_request(circle.back()) && planted_[node(circle.back()).segment] < most_askings &&
           !std::all_of(circle.begin(), circle.end(), [this](NodeId index) { return takes_request(index); });
  }

  /// The segment of a cycle of causes at which its jobs are counted. If there is one, it belongs to a client:
  /// a thread that in this cycle only waits for answers to its requests.
  SegmentId cut(const std::vector<NodeId>& circle) {
    const auto asks_only = [this](NodeId index) {
      const Beginning& begins = forest_.segment_of(node(index)).beginning;
      if (begins.kind == Beginning::Kind::give_up) return true;
      if (begins.kind != Beginning::Kind::arm) return false;
      const ChannelId channel = step_at(begins.step).channels[static_cast<std::size_t>(begins.arm)];
      return problem_.channels[channel].answers.valid();
    };
    for (const NodeId index : circle) {
      const ThreadId thread = forest_.thread_of(index);
      const bool client = std::all_of(circle.begin(), circle.end(), [&](NodeId other) {
        return forest_.thread_of(other) != thread || asks_only(other);
      });
      if (client) return node(index).segment;
    }
    return node(circle.back()).segment;
  }

  const Problem& problem_;
  Forest& forest_;
  const std::function<bool()>& stop_;
  Sequence sequence_;
  Takers takers_;
  Table<StepId, bool> limited_;  // by wait: each of its branches is counted as an effect of reaching it
  std::set<SegmentId> cuts_;
  std::set<SegmentId> found_;
  std::map<SegmentId, std::vector<std::vector<StepId>>> alternatives_;  // by segment
  std::map<SegmentId, bool> comes_again_;
  std::map<SegmentId, int> planted_;  // by segment: nodes
  std::vector<NodeId> open_;
  std::size_t most_nodes_ = 0;
};

}  // namespace

Forest forest_of(const Problem& problem, const std::function<bool()>& stop, const SetAside& set_aside) {
  Forest forest(problem);
  forest.set_aside = set_aside;
  ForestBuilder(problem, forest, stop).plant();
  return forest;
}

}  // namespace pal::analyzer::compositional
