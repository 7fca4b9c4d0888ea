// Interference: the work of other nodes that delays a node on its processor.
#pragma once

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/causes/since_cause.hpp"
#include "analyzer/compositional/times/busy_window.hpp"
#include "analyzer/compositional/times/excluded_work.hpp"
#include "analyzer/compositional/times/times.hpp"

namespace pal::analyzer::compositional {

class Interference {
 public:
  /// Registers each node as a task of its source's transaction; the offset is its earliest release. Must not
  /// be used after `stop` has returned true.
  Interference(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes,
               const std::function<bool()>& stop, WindowEnds ends);

  /// Sets the release jitter of the node.
  void announce(NodeId node, const NodeTimes& times);
  /// A bound of the release jitter, however late a node's causes are. One message in each slot and one in
  /// each thread can be queued on the way to it.
  Nanoseconds greatest_jitter(NodeId node) const;
  /// The same for alternatives taken together, whose paths may share slots and threads.
  Nanoseconds piled_up(const std::vector<NodeId>& alternatives) const;
  /// Removes interference between nodes that never overlap. `done_before_next`, by thread: each job ends
  /// before the next is released, so jobs of the thread do not delay one another. `in_turn`, by source: all
  /// that an occurrence triggers ends before the next occurrence. So its nodes that follow or exclude one
  /// another do not delay one another.
  void find_order(const Table<ThreadId, bool>& done_before_next, const Table<SourceId, bool>& in_turn,
                  const std::function<bool()>& stop);
  /// How long threads occupy a processor that is not preemptive once they have it. By thread:
  /// `done_before_next`, each job ends before the next is released; `blocked`, it may be blocked in a send.
  void find_bursts(const Table<NodeId, NodeTimes>& nodes, const Table<ThreadId, bool>& done_before_next,
                   const Table<ThreadId, bool>& blocked);
  /// The longest blocking of the node by threads of lower priority, if its processor is not preemptive.
  Nanoseconds blocking(NodeId node) const;
  /// How long after the source's nominal instant, or the node's release, the first `part` of the node's work
  /// is done at the latest.
  Nanoseconds finish(NodeId node, Nanoseconds part, Nanoseconds blocking,
                     Since since = Since::occurrence) const;
  /// finish() of each of several parts, counted from the nominal instant.
  std::vector<Nanoseconds> finishes(NodeId node, const std::vector<Nanoseconds>& parts,
                                    Nanoseconds blocking) const;
  /// What goes into finish() besides the latest release and the work itself.
  FinishBreakdown breakdown(NodeId node, Nanoseconds part, Since since = Since::occurrence) const;
  /// The same for nodes of one occurrence that keep a processor busy one after the other (joint_chain()). The
  /// time counts from the release of the first one to `part` of the last one.
  Nanoseconds joint_finish(const std::vector<NodeId>& chain, Nanoseconds part) const;
  std::vector<Share> joint_breakdown(const std::vector<NodeId>& chain, Nanoseconds part) const;
  /// The thread of lower priority that blocks the node longest.
  ThreadId blocking_thread(NodeId node) const;
  NodeId node_of(TransactionId transaction, TaskId task) const { return nodes_of_[transaction][task]; }
  const BusyWindows& windows() const { return windows_; }
  SinceCause since_cause() const { return {context_, order_}; }
  /// Its numbers are final: `stop` is not asked any more.
  void go_on() { windows_.go_on(); }

 private:
  /// A transaction for each source.
  TransactionId transaction_of(NodeId node) const {
    return TransactionId::of(context_.node(node).source.value);
  }
  void precede(const AnalysisContext& context, NodeId node, Table<SourceId, Transaction>& transactions) const;
  void exclude(NodeId node, bool done_before_next, bool in_turn);
  void separate(NodeId node, const std::set<NodeId>& excluded);
  template <class JobsOf>
  Nanoseconds work_of_thread(ThreadId thread, const JobsOf& jobs_of) const;
  Nanoseconds burst(ThreadId thread, const Table<NodeId, NodeTimes>& nodes, bool done_before_next) const;
  bool pauses(ThreadId thread) const;
  std::vector<TaskId> tasks_of(const std::vector<NodeId>& nodes) const;

  AnalysisContext context_;
  BusyWindows windows_;
  Table<NodeId, TaskId> task_;
  Table<TransactionId, Table<TaskId, NodeId>> nodes_of_;
  Table<ProcessorId, std::vector<ThreadId>> threads_on_;  // by processor
  Table<ThreadId, Nanoseconds> burst_;                    // by thread
  std::shared_ptr<const Order> order_;
  ExcludedWork excluded_;
  SinceCause since_cause_;
  Table<ThreadId, bool> done_before_next_;  // by thread, as given
  Table<SourceId, bool> in_turn_;           // as given
  Table<ThreadId, bool> pauses_;            // by thread: it is not free-running, or always waits in each job
};

/// How long a cancelled block, and the blocks that it has started, may take to finish what they have begun.
Nanoseconds stops_within(const Problem& problem, const BusyWindows& windows, ThreadId block);

}  // namespace pal::analyzer::compositional
