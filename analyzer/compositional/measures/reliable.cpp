#include "analyzer/compositional/measures/reliable.hpp"

#include <algorithm>

#include "analyzer/compositional/causes/job_distance.hpp"
#include "analyzer/compositional/measures/measures.hpp"
#include "analyzer/compositional/times/interference.hpp"
#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;

class Reliability {
 public:
  /// `steady`: as long as no block has left its loop.
  Reliability(const Problem& problem, const Forest& forest, const ThreadBehaviours& behaviours,
              const Times& times, bool steady)
      : problem_(problem), forest_(forest), behaviours_(behaviours), times_(times), steady_(steady) {}

  /// The greatest set of threads each of which relies on members alone.
  Endurance::Threads run() {
    const std::size_t count = problem_.threads.size();
    Table<ThreadId, std::vector<ThreadId>> relies(count);
    Table<ThreadId, std::vector<ThreadId>> begins_by(count);
    made_.reliable.assign(count, false);
    made_.lively.assign(count, false);
    made_.begun.assign(count, true);
    for (const ThreadId t : relies.ids()) {
      const ThreadBehaviour& of = behaviours_.threads[t];
      const bool goes_on = servers(t, relies[t]) && joins(t, relies[t]);
      made_.lively[t] = times_.unbounded_reason[t].empty() && goes_on;
      made_.begun[t] = comes_to_begin(t, begins_by[t]);
      made_.reliable[t] =
          made_.lively[t] && returns_to_idle_wait(t) && (!of.leaves || (steady_ && may_leave(problem_, t)));
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (const ThreadId t : relies.ids()) {
        const auto serve = [this](ThreadId other) {
          return made_.reliable[other] && made_.begun[other] && lasts(other);
        };
        const bool sound = std::all_of(relies[t].begin(), relies[t].end(), serve);
        const ThreadId parent = problem_.threads[t].parent;
        const bool begun = made_.begun[t] && std::all_of(begins_by[t].begin(), begins_by[t].end(), serve) &&
                           (!parent.valid() || made_.begun[parent]);
        const bool returns = made_.reliable[t] && sound && (!steady_ || lasts(t));
        if (made_.lively[t] == (made_.lively[t] && sound) && made_.reliable[t] == returns &&
            made_.begun[t] == begun)
          continue;
        made_.lively[t] = made_.lively[t] && sound;
        made_.begun[t] = begun;
        made_.reliable[t] = returns;
        changed = true;
      }
    }
    return std::move(made_);
  }

 private:
  const Step& step_at(StepId step) const { return problem_.steps[step]; }

  bool lasts(ThreadId thread) const { return !behaviours_.threads[thread].may_be_cancelled; }

  /// Whether no way through a thread ends, or comes to blocks that never do, before it has returned to its
  /// idle wait.
  bool returns_to_idle_wait(ThreadId thread) const {
    const StepId idle_wait = behaviours_.threads[thread].idle_wait;
    if (!idle_wait.valid()) return false;
    return !follow(problem_, {entry_of(thread)}, [&](StepId at) {
      if (at == idle_wait) return Course::ends;
      return is_last(step_at(at)) ? Course::found : Course::goes_on;
    });
  }

  StepId entry_of(ThreadId thread) const { return problem_.threads[thread].entry; }

  /// Whether its thread does not go on after a step.
  bool is_last(const Step& step) const {
    return step.kind == Kind::end || (step.kind == Kind::fork && !goes_on_after(step));
  }

  bool goes_on_after(const Step& fork) const {
    return std::any_of(fork.threads.begin(), fork.threads.end(),
                       [this](ThreadId block) { return problem_.threads[block].can_end; });
  }

  /// Whether a thread begins at the start of the skill, or on every path of its parent before its first job.
  /// The threads that it relies on must go on.
  bool comes_to_begin(ThreadId thread, std::vector<ThreadId>& relies) const {
    const ThreadId parent = problem_.threads[thread].parent;
    if (!parent.valid()) return true;
    const StepId fork = fork_of(problem_, thread);
    const StepId idle_wait = behaviours_.threads[parent].idle_wait;
    std::set<StepId> before;
    const bool passed_by = follow(problem_, {entry_of(parent)}, [&](StepId at) {
      if (at == fork) return Course::ends;
      before.insert(at);
      return at == idle_wait || is_last(step_at(at)) ? Course::found : Course::goes_on;
    });
    if (passed_by) return false;
    for (NodeId n : behaviours_.threads[parent].nodes) {
      for (const Segment::Arrival& at : forest_.segment_of(forest_.nodes[n]).forks) {
        if (before.contains(at.step) && !joins_at(at.step, relies)) return false;
      }
    }
    return sends_through(parent, before, relies) &&
           std::all_of(before.begin(), before.end(), [&](StepId step) {
             return step_at(step).kind != Kind::wait || comes(parent, step, relies);
           });
  }

  /// Whether a thread's sends, those of `among`, do not wait for ever, if their takers go on.
  bool sends_through(ThreadId thread, const std::set<StepId>& among, std::vector<ThreadId>& relies) const {
    const auto may_wait = [this](StepId step) {
      const Step& send = step_at(step);
      return send.kind == Kind::send && !problem_.channels[send.channels.front()].receiver_device.valid() &&
             !behaviours_.never_full[send.channels.front()];
    };
    if (times_.blocked[thread] && std::any_of(among.begin(), among.end(), may_wait)) return false;
    for (NodeId n : behaviours_.threads[thread].nodes) {
      for (NodeId effect : forest_.nodes[n].effects) {
        const std::vector<StepId>& sends = forest_.nodes[effect].sends;
        const bool waits = std::any_of(sends.begin(), sends.end(),
                                       [&](StepId send) { return among.contains(send) && may_wait(send); });
        if (waits) relies.push_back(forest_.thread_of(effect));
      }
    }
    return true;
  }

  /// Whether the blocks that a thread starts all come to their end, on the way to its idle wait.
  bool joins(ThreadId thread, std::vector<ThreadId>& relies) const {
    for (NodeId n : behaviours_.threads[thread].nodes) {
      const Node& node = forest_.nodes[n];
      for (const Segment::Arrival& fork : forest_.segment_of(node).forks) {
        if (!joins_at(fork.step, relies)) return false;
      }
    }
    return true;
  }

  bool joins_at(StepId fork, std::vector<ThreadId>& relies) const {
    for (ThreadId block : step_at(fork).threads) {
      const ThreadId b = block;
      if (!problem_.threads[b].can_end) continue;
      if (!ends_straight(problem_, block) || !times_.unbounded_reason[b].empty()) return false;
      // What comes by itself need not come.
      if (behaviours_.threads[b].idle_wait.valid()) return false;
      if (!servers(block, relies) || !joins(block, relies)) return false;
    }
    return true;
  }

  /// The threads that answer what `thread` waits for; false: something that it waits for may never come.
  bool servers(ThreadId thread, std::vector<ThreadId>& relies) const {
    const ThreadBehaviour& of = behaviours_.threads[thread];
    std::set<StepId> waits;
    for (NodeId n : of.nodes) {
      const Node& node = forest_.nodes[n];
      for (const Segment::Arrival& wait : forest_.segment_of(node).waits) waits.insert(wait.step);
    }
    for (NodeId n : of.nodes) {
      const Node& node = forest_.nodes[n];
      for (NodeId effect : node.effects) {
        // A message that no thread takes would stop its sender, sooner or later.
        const Node& taker = forest_.nodes[effect];
        if (taker.release != Node::Release::message || taker.device.valid()) continue;
        const ChannelId channel = step_at(taker.sends.front()).channels.front();
        if (behaviours_.never_full[channel]) continue;
        relies.push_back(forest_.thread_of(effect));
      }
    }
    return std::all_of(waits.begin(), waits.end(), [&](StepId wait) {
      return (wait == of.idle_wait && !goes_on_by_itself(of)) || comes(thread, wait, relies);
    });
  }

  /// Whether a wait ends: it gives up, or what it waits for has been asked for and is answered, if the server
  /// goes on.
  bool comes(ThreadId thread, StepId wait, std::vector<ThreadId>& relies) const {
    const Step& step = step_at(wait);
    if (step.within) return true;
    if (step.channels.size() != 1) return false;
    const ChannelId answer = step.channels.front();
    const Channel& channel = problem_.channels[answer];
    if (!channel.answers.valid()) return false;
    if (!surely_asked(thread, wait, channel.answers, answer)) return false;
    if (channel.sender_device.valid()) return serves_all(problem_.devices[channel.sender_device]);
    if (!behaviours_.never_full[answer]) return false;
    const ThreadId server = taker_of(channel.answers);
    if (!server.valid()) return false;
    relies.push_back(server);
    return true;
  }

  /// Whether a device serves each request sooner or later. One that takes any of several that wait may leave
  /// one of them for ever.
  static bool serves_all(const Device& device) {
    if (std::holds_alternative<pan::RequestDevice>(device.behaviour)) return device.requests.size() == 1;
    return std::holds_alternative<pan::FrameDevice>(device.behaviour);
  }

  bool goes_on_by_itself(const ThreadBehaviour& of) const {
    return std::any_of(of.job_starts.begin(), of.job_starts.end(), [&](NodeId n) {
      const Node& node = forest_.nodes[n];
      return forest_.sources[node.source].kind == Source::Kind::loop && !node.cause.valid();
    });
  }

  /// The only thread that receives a request, and at its idle wait, if there is one.
  ThreadId taker_of(ChannelId request) const {
    ThreadId server{};
    for (const StepId s : problem_.steps.ids()) {
      const Step& step = problem_.steps[s];
      if (step.kind != Kind::wait) continue;
      if (std::find(step.channels.begin(), step.channels.end(), request) == step.channels.end()) continue;
      const ThreadId owner = forest_.segments.owner(s);
      if (!owner.valid()) continue;
      if (server.valid() || behaviours_.threads[owner].idle_wait != s) return ThreadId{};
      server = owner;
    }
    return server;
  }

  /// Whether a wait of a block, or of one below it, may take the message, or give it up.
  bool may_take(ThreadId block, ChannelId message) const {
    for (const StepId s : problem_.steps.ids()) {
      const Step& step = problem_.steps[s];
      if (step.kind != Kind::wait) continue;
      if (std::find(step.channels.begin(), step.channels.end(), message) == step.channels.end()) continue;
      for (ThreadId at = forest_.segments.owner(s); at.valid(); at = problem_.threads[at].parent) {
        if (at == block) return true;
      }
    }
    return false;
  }

  /// Whether the thread has sent the request, and neither it nor a block of it has taken the answer, whenever
  /// it comes to the wait.
  bool surely_asked(ThreadId thread, StepId wait, ChannelId request, ChannelId answer) const {
    std::vector<StepId> open{entry_of(thread)};
    for (const StepId s : problem_.steps.ids()) {
      const Step& step = problem_.steps[s];
      if (forest_.segments.owner(s) != thread) continue;
      const auto takes = [&](ThreadId block) { return may_take(block, answer); };
      if (std::any_of(step.threads.begin(), step.threads.end(), takes)) open.push_back(step.next.front());
      if (step.kind != Kind::wait) continue;
      for (std::size_t arm = 0; arm < step.channels.size(); ++arm) {
        if (step.channels[arm] != answer) continue;
        open.push_back(step.next[arm]);
        if (step.within) open.push_back(step.next.back());
      }
    }
    return !follow(problem_, open, [&](StepId at) {
      if (at == wait) return Course::found;
      const Step& step = step_at(at);
      return step.kind == Kind::send && step.channels.front() == request ? Course::ends : Course::goes_on;
    });
  }

  const Problem& problem_;
  const Forest& forest_;
  const ThreadBehaviours& behaviours_;
  const Times& times_;
  bool steady_;
  Endurance::Threads made_;
};

}  // namespace

bool may_leave(const Problem& problem, ThreadId thread) {
  return problem.threads[thread].parent.valid() &&
         !recurrent(problem, {Beginning::Kind::entry, thread, {}, -1});
}

Endurance::Threads threads_that_endure(const Problem& problem, const Forest& forest,
                                       const ThreadBehaviours& behaviours, const Times& times, bool steady) {
  return Reliability(problem, forest, behaviours, times, steady).run();
}

}  // namespace pal::analyzer::compositional
