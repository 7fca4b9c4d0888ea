// How fresh the data of a thread are. It is the least recent sample of a device, or set of a condition, that
// the thread may work with.
#pragma once

#include <memory>
#include <optional>

#include "analyzer/compositional/causes/since_cause.hpp"
#include "analyzer/compositional/measures/statement_occurrences.hpp"

namespace pal::analyzer::compositional {

/// Data only get fresher: a read or a message never replaces data of a thread by older ones. So each path by
/// which data must arrive gives a lower bound of the instant of their sample. It counts from the nominal
/// instant of the node's source. If that instant plus the bound is not after time 0, the thread may have no
/// data yet. Data that it has are younger than the skill.
///
/// M. Günzel and others, Timing analysis of asynchronized distributed cause-effect chains, 2021. The chains
/// are followed backward, from the statement to the last message or read before it.
class DataFreshness {
 public:
  struct Instant {
    Sum at;
    std::optional<StepEffect> request{};  // the request whose answer is the sample, if it is known
  };
  /// The instant of the sample, or one before it; nothing: there may be no sample.
  using Known = std::optional<Instant>;

  DataFreshness(const View& view, const Requirement& requirement);

  /// At the effect of a step in a node.
  Known at(StepEffect effect) const;
  /// Greatest age of the sample at the effect of a step, counted from a common cause of that effect and of
  /// the request for the sample.
  Sum age_since_cause(StepEffect effect) const;
  /// `what`, followed by the reason why nothing is known of the thread's earlier jobs, or by that of the
  /// unbounded thread behind it, if there is one.
  Why with_reason(Why what, ThreadId thread) const;

 private:
  struct State {
    Known known;
    Known set;  // the last set of the condition on the thread's own path
  };
  struct Setter {
    ThreadId thread;
    std::unique_ptr<StatementOccurrences> sets;
  };

  void find_setters();
  bool visit(NodeId node);
  State begin(NodeId node) const;
  State before_idle(NodeId node) const;
  /// Whether jobs of the thread may come in another order than their causes.
  bool overtakes(ThreadId thread) const;
  Known set_by_blocks(const Node& joined) const;
  Known told(NodeId node) const;
  Known told_by(NodeId sender, const std::vector<StepId>& sends, DeviceId device) const;
  Known told_in_loop(const Source& source, SourceId index) const;
  void transfer(NodeId node, StepId step, State& state);
  Sum age_when_read(ConditionId condition, ThreadId reader);
  Sum sample_age(ConditionId condition, ThreadId reader) const;
  bool surely_read(StepId step, ConditionId condition) const;
  bool sampled(ChannelId channel) const;

  const View& view_;
  const Problem& problem_;
  const Requirement& requirement_;
  mutable SinceCause since_cause_;
  Table<NodeId, State> begins_;
  Table<NodeId, std::vector<Known>> effects_;        // by place in its segment
  Table<NodeId, std::map<StepId, State>> arrivals_;  // at the waits and forks that end it
  Table<ThreadId, bool> regular_;                    // by thread
  Table<ThreadId, std::set<ConditionId>> latched_;   // by thread: conditions that it reads by RPC
  std::map<ConditionId, Table<StepId, bool>> set_at_;
  std::map<ConditionId, std::vector<Setter>> setters_;
  std::map<std::pair<ConditionId, ThreadId>, Sum> ages_;  // by condition and reader
};

}  // namespace pal::analyzer::compositional
