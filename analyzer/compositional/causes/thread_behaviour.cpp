#include "analyzer/compositional/causes/thread_behaviour.hpp"

#include <algorithm>
#include <set>

#include "analyzer/compositional/causes/alternatives.hpp"
#include "analyzer/compositional/causes/job_distance.hpp"
#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;
using Release = Node::Release;

class Observer {
 public:
  Observer(const Problem& problem, const Forest& forest) : problem_(problem), forest_(forest) {}

  ThreadBehaviours run(const std::function<bool()>& stop) {
    const std::size_t nodes = forest_.nodes.size();
    made_.threads.resize(problem_.threads.size());
    made_.job_start.assign(nodes, {});
    made_.previous.resize(nodes);
    for (const NodeId n : forest_.nodes.ids()) made_.threads[forest_.thread_of(n)].nodes.push_back(n);
    for (const ThreadId t : problem_.threads.ids()) find_idle_wait(t);
    for (const NodeId n : forest_.nodes.ids()) find_job_start(n);
    for (const NodeId n : forest_.nodes.ids()) {
      if (stop && stop()) break;
      order(n);
    }
    for (const ThreadId t : problem_.threads.ids()) {
      leftovers(t);
      returns(t);
    }
    made_.early.assign(nodes, true);
    for (const ThreadId t : problem_.threads.ids()) find_early(t);
    find_waits();
    for (const NodeId n : forest_.nodes.ids()) made_.drains.push_back(drains(n));
    protocol();
    for (ThreadBehaviour& thread : made_.threads) {
      thread.one_job = are_alternatives(problem_, forest_, thread.job_starts);
      servers(thread);
    }
    made_.alternatives = alternatives_of(problem_, forest_, stop);
    find_endings();
    return std::move(made_);
  }

 private:
  const Node& node(NodeId index) const { return forest_.nodes[index]; }
  const Beginning& beginning(NodeId index) const { return forest_.segment_of(node(index)).beginning; }
  ThreadBehaviour& thread(ThreadId index) { return made_.threads[index]; }
  const Step& step_at(StepId step) const { return problem_.steps[step]; }
  std::string text(StepId step) const {
    const StatementId statement = step_at(step).statement;
    return !statement.valid() ? "a wait" : problem_.statements[statement].text;
  }

  const std::string& name_of(ThreadId t) const { return problem_.threads[t].name; }

  void leave_unbounded(ThreadId t, Why because) {
    if (forest_.withholds(because)) thread(t).unbounded_reason = std::move(because);
  }

  /// Released by something that the thread did not bring about itself.
  bool unasked(NodeId index) const {
    const Beginning& begins = beginning(index);
    if (begins.kind != Beginning::Kind::arm && begins.kind != Beginning::Kind::give_up) return false;
    if (node(index).release == Release::root) return true;
    return node(index).release == Release::message && !forest_.cause_in(index, begins.thread).valid();
  }

  void find_idle_wait(ThreadId t) {
    ThreadBehaviour& of = thread(t);
    for (NodeId n : of.nodes) {
      if (!unasked(n)) continue;
      const StepId wait = beginning(n).step;
      if (of.idle_wait.valid() && of.idle_wait != wait)
        leave_unbounded(t, why(Withheld::two_idle_waits, name_of(t), text(of.idle_wait), text(wait)));
      of.idle_wait = wait;
    }
  }

  /// Causes stand before their effects, so a node's job is known when it is needed.
  void find_job_start(NodeId n) {
    const Beginning& begins = beginning(n);
    ThreadBehaviour& of = thread(begins.thread);
    NodeId& job_start = made_.job_start[n];
    switch (node(n).release) {
      case Release::root:
        job_start = n;
        break;
      case Release::fork:
        job_start = begins.kind == Beginning::Kind::joined ? made_.job_start[node(n).cause] : n;
        break;
      case Release::limit:
        job_start = made_.job_start[node(n).cause];
        break;
      case Release::message: {
        const NodeId before = forest_.cause_in(n, begins.thread);
        const bool begins_job = !before.valid() || begins.step == of.idle_wait;
        job_start = begins_job ? n : made_.job_start[before];
        break;
      }
    }
    const bool waited = begins.kind == Beginning::Kind::arm || begins.kind == Beginning::Kind::give_up;
    if (job_start == n && waited) of.job_starts.push_back(n);
    for (const Segment::Arrival& wait : forest_.segment_of(node(n)).waits)
      arrivals_[{job_start, wait.step}].push_back(n);
  }

  void order(NodeId n) {
    if (made_.job_start[n] == n) return;
    auto& previous = made_.previous[n];
    if (node(n).release != Release::message) {
      previous.push_back(node(n).cause);
      return;
    }
    const Beginning& begins = beginning(n);
    // It may come twice for what the job has sent; then the next job takes what this one has brought
    // about.
    const ChannelId channel = step_at(begins.step).channels[static_cast<std::size_t>(begins.arm)];
    const bool again = forest_.sources[node(n).source].period < never;
    if (again && !problem_.channels[channel].answers.valid())
      leave_unbounded(begins.thread, why(Withheld::waits_unasked, name_of(begins.thread), text(begins.step)));
    const auto known = arrivals_.find({made_.job_start[n], begins.step});
    if (known != arrivals_.end()) previous = known->second;
    if (previous.empty())
      leave_unbounded(begins.thread,
                      why(Withheld::waits_for_other_job, name_of(begins.thread), text(begins.step)));
    waited_for_.insert({made_.job_start[n], begins.step});
  }

  /// What a job brings about it must also take: else a later job finds it in the slot, and takes it for
  /// its own.
  void leftovers(ThreadId t) {
    // By channel of what comes back: sends, and forks to the senders.
    std::map<ChannelId, std::set<StepId>> origins;
    for (NodeId n : thread(t).nodes) {
      if (node(n).release != Release::message || made_.job_start[n] == n) continue;
      NodeId first = n;  // of what the thread brings about on the way
      while (forest_.thread_of(node(first).cause) != t) first = node(first).cause;
      const Beginning& begins = beginning(n);
      std::set<StepId>& of = origins[step_at(begins.step).channels[static_cast<std::size_t>(begins.arm)]];
      of.insert(node(first).sends.begin(), node(first).sends.end());
      if (node(first).release == Release::fork) of.insert(node(first).cause_step);
    }
    for (const auto& [channel, from] : origins) {
      if (is_taken(t, channel, from)) continue;
      leave_unbounded(t, why(Withheld::left_to_later_job, name_of(t), problem_.channels[channel].message));
    }
  }

  /// Whether a thread that has passed one of the steps `from` takes a message, or withdraws it, in time. That
  /// is before it passes another such step, returns to its idle wait, or ends and may begin again.
  bool is_taken(ThreadId t, ChannelId channel, const std::set<StepId>& from) {
    const bool answer = problem_.channels[channel].answers.valid();
    const bool again = recurrent(problem_, {Beginning::Kind::entry, t, {}, -1});
    std::set<StepId> seen;
    std::vector<StepId> open;
    for (StepId origin : from)
      open.insert(open.end(), step_at(origin).next.begin(), step_at(origin).next.end());
    while (!open.empty()) {
      const StepId at = open.back();
      open.pop_back();
      const Step& step = step_at(at);
      if (at == thread(t).idle_wait || from.contains(at) || (step.kind == Kind::end && again)) return false;
      if (!seen.insert(at).second) continue;
      bool waits = false;
      for (std::size_t i = 0; i < step.next.size(); ++i) {
        const bool arm = step.kind == Kind::wait && i < step.channels.size();
        if (arm && step.channels[i] == channel) {
          waits = true;
          continue;
        }
        if (!arm && waits && answer) continue;  // withdrawn
        open.push_back(step.next[i]);
      }
    }
    return true;
  }

  /// A job ends at the idle wait, and waits before only for what it has triggered itself.
  void returns(ThreadId t) {
    ThreadBehaviour& of = thread(t);
    for (ThreadId block = t; problem_.threads[block].parent.valid(); block = problem_.threads[block].parent) {
      of.may_be_cancelled = of.may_be_cancelled || is_cancelled(block);
    }
    if (!of.idle_wait.valid()) return;
    // What is for it waits while it is not there.
    if (recurrent(problem_, {Beginning::Kind::entry, t, {}, -1}))
      leave_unbounded(t, why(Withheld::started_again, name_of(t)));
    for (NodeId n : of.nodes) {
      const NodeId job_start = made_.job_start[n];
      const Segment& segment = forest_.segment_of(node(n));
      const bool again = in_job(forest_, made_, n);
      for (const Segment::Arrival& wait : segment.waits) {
        if (wait.step == of.idle_wait) continue;
        const bool limited = step_at(wait.step).within.has_value();
        if (again) of.waits_within = true;
        if (!limited && !waited_for_.contains({job_start, wait.step}))
          leave_unbounded(t, why(Withheld::waits_untriggered, name_of(t), text(wait.step)));
      }
      if (again && segment.ends) of.leaves = true;
      for (const Segment::Arrival& fork : segment.forks) {
        if (!again) continue;
        of.waits_within = true;
        if (!ends_within(fork.step)) leave_unbounded(t, why_of_blocks(t, fork.step));
      }
    }
  }

  /// Why nothing is known of when blocks begin that do not end within the job that starts them.
  Why why_of_blocks(ThreadId t, StepId fork) {
    if (recurrent(problem_, {Beginning::Kind::joined, t, fork, -1}))
      return why(Withheld::blocks_again, name_of(t));
    return why(Withheld::blocks_once, name_of(t), text(thread(t).idle_wait));
  }

  /// ThreadBehaviours::early: no way leads from a wait at which a job begins to where the node begins, and
  /// the thread begins once.
  void find_early(ThreadId t) {
    const ThreadBehaviour& of = thread(t);
    const bool again = recurrent(problem_, {Beginning::Kind::entry, t, {}, -1});
    std::set<StepId> late;
    std::vector<StepId> waits;
    for (NodeId n : of.job_starts) waits.push_back(beginning(n).step);
    follow(problem_, waits, [&late](StepId at) {
      late.insert(at);
      return Course::goes_on;
    });
    for (NodeId n : of.nodes) made_.early[n] = !again && !late.contains(beginning(n).step);
  }

  /// Whether a block stops when its siblings have ended.
  bool is_cancelled(ThreadId block) const {
    if (problem_.threads[block].can_end) return false;
    return std::any_of(problem_.steps.begin(), problem_.steps.end(), [&](const Step& step) {
      return std::find(step.threads.begin(), step.threads.end(), block) != step.threads.end() &&
             std::any_of(step.threads.begin(), step.threads.end(),
                         [&](ThreadId other) { return problem_.threads[other].can_end; });
    });
  }

  /// Whether all blocks of a CONCURRENT end without jobs of their own.
  bool ends_within(StepId fork) {
    const std::vector<ThreadId>& blocks = step_at(fork).threads;
    return std::all_of(blocks.begin(), blocks.end(), [this](ThreadId block) {
      return problem_.threads[block].can_end && !thread(block).idle_wait.valid() &&
             ends_straight(problem_, block);
    });
  }

  void find_waits() {
    waits_.resize(problem_.channels.size());
    for (const StepId s : problem_.steps.ids()) {
      const Step& step = problem_.steps[s];
      if (step.kind != Kind::wait || !forest_.segments.owner(s).valid()) continue;
      for (ChannelId channel : step.channels) waits_[channel].push_back(s);
    }
  }

  /// ThreadBehaviours::drains: the only thread that receives the message waits for nothing but at its idle
  /// wait.
  bool drains(NodeId n) {
    const ThreadBehaviour& of = thread(forest_.thread_of(n));
    if (node(n).release != Release::message || node(n).device.valid() || of.waits_within) return false;
    if (made_.job_start[n] != n || !made_.previous[n].empty()) return false;
    const ChannelId channel = step_at(node(n).sends.front()).channels.front();
    if (latency(problem_, channel, forest_.thread_of(node(n).cause), forest_.thread_of(n)).worst > 0)
      return false;
    const std::vector<StepId>& waits = waits_[channel];
    return std::all_of(waits.begin(), waits.end(), [&of](StepId wait) { return wait == of.idle_wait; });
  }

  void protocol() {
    made_.never_full.assign(problem_.channels.size(), false);
    for (const ChannelId c : problem_.channels.ids()) {
      const Channel& channel = problem_.channels[c];
      made_.never_full[c] =
          channel.answer.valid() || (channel.answers.valid() && channel.sender_module.valid());
    }
  }

  void find_endings() {
    made_.endings.resize(forest_.sources.size());
    made_.start_endings.resize(problem_.threads.size());
    for (const NodeId n : forest_.nodes.ids()) {
      const Node& of = forest_.nodes[n];
      if (!may_end(problem_, forest_.segment_of(of))) continue;
      made_.endings[of.source].push_back(n);
      if (forest_.sources[of.source].kind == Source::Kind::start) end_at_start(n);
    }
  }

  void end_at_start(NodeId ending) {
    std::set<ThreadId> threads;
    for (NodeId n = ending; n.valid(); n = node(n).cause) {
      const ThreadId thread = forest_.thread_of(n);
      if (thread.valid() && threads.insert(thread).second) made_.start_endings[thread].push_back({ending, n});
    }
  }

  /// A server whose jobs wait may still be at work when a request comes. It is idle if its only client waits
  /// for each answer without limit, and it has nothing left to do after the answer.
  void servers(ThreadBehaviour& of) {
    if (of.job_starts.empty()) return;
    ChannelId request{};
    for (NodeId n : of.job_starts) {
      const Beginning& begins = beginning(n);
      if (begins.kind != Beginning::Kind::arm) return;
      const ChannelId channel = step_at(begins.step).channels[static_cast<std::size_t>(begins.arm)];
      if (request.valid() && channel != request) return;
      request = channel;
    }
    const Channel& channel = problem_.channels[request];
    // A device that sends requests by itself waits for no answer.
    if (!channel.answer.valid() || channel.sender_device.valid()) return;
    for (const Step& step : problem_.steps) {
      const bool gives_up =
          step.kind == Kind::wait && step.within &&
          std::find(step.channels.begin(), step.channels.end(), channel.answer) != step.channels.end();
      if (gives_up) return;
    }
    for (NodeId n : of.nodes) {
      const Segment& segment = forest_.segment_of(node(n));
      for (const Segment::Arrival& wait : segment.waits) {
        if (wait.step != of.idle_wait) continue;
        // The answer is the last thing on the way to the idle wait.
        bool answered = false;
        for (const Segment::Passed& passed : segment.steps) {
          const Step& step = step_at(passed.step);
          const bool ends_job =
              std::find(step.next.begin(), step.next.end(), of.idle_wait) != step.next.end();
          const bool answers = step.kind == Kind::send && step.channels.front() == channel.answer;
          if (ends_job && !answers) return;
          answered = answered || answers;
        }
        if (in_job(forest_, made_, n) && !answered) return;
      }
    }
    of.asked_by_one = true;
  }

  const Problem& problem_;
  const Forest& forest_;
  ThreadBehaviours made_;
  std::map<std::pair<NodeId, StepId>, std::vector<NodeId>> arrivals_;  // by job and wait
  Table<ChannelId, std::vector<StepId>> waits_;                        // by channel, that take from it
  std::set<std::pair<NodeId, StepId>> waited_for_;                     // job and wait
};

}  // namespace

bool in_job(const Forest& forest, const ThreadBehaviours& behaviours, NodeId node) {
  const std::vector<NodeId>& job_starts = behaviours.threads[forest.thread_of(node)].job_starts;
  return std::find(job_starts.begin(), job_starts.end(), behaviours.job_start[node]) != job_starts.end();
}

ThreadBehaviours thread_behaviours_of(const Problem& problem, const Forest& forest,
                                      const std::function<bool()>& stop) {
  return Observer(problem, forest).run(stop);
}

}  // namespace pal::analyzer::compositional
