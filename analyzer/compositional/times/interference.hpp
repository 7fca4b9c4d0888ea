// The work that nodes bring to their processors.
#pragma once

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/causes/precedence.hpp"
#include "analyzer/compositional/times/busy_window.hpp"
#include "analyzer/compositional/times/times.hpp"

namespace pal::analyzer::compositional {

class Interference {
 public:
  /// Registers each node as a task of its source's transaction, released at its earliest.
  /// Once `stop` says so, it is of no use.
  Interference(const AnalysisContext& context, const std::vector<NodeTimes>& nodes,
               const std::function<bool()>& stop);

  /// Tells the windows how late the node may be released after its earliest.
  void announce(int node, const NodeTimes& times);
  /// However late a node's causes are: what can have piled up on the way to it is one message a slot and one
  /// a thread.
  Nanoseconds greatest_jitter(int node) const;
  /// The same of alternatives taken together, whose ways have slots and threads of their own and in common.
  Nanoseconds piled_up(const std::vector<int>& alternatives) const;
  /// Says, as releases are announced, of which threads no round is due before the one before is over
  /// (`done_before_next`): rounds of one thread do not delay one another then; and of which sources all that
  /// an occurrence brings about is over before the next one (`in_turn`): what comes one after the other, or
  /// one in place of the other, does not, either.
  void find_order(const std::vector<bool>& done_before_next, const std::vector<bool>& in_turn,
                  const std::function<bool()>& stop);
  /// How long threads keep a processor that is not preemptive once they have it, as releases are announced.
  /// By thread: `done_before_next`, no round is due before the one before is over; `blocked`, it may have to
  /// wait in a send.
  void find_bursts(const std::vector<NodeTimes>& nodes, const std::vector<bool>& done_before_next,
                   const std::vector<bool>& blocked);
  /// The longest that threads of lower priority keep the node's processor, if it is not preemptive.
  Nanoseconds blocking(int node) const;
  /// How long after the source's nominal instant, or the node's release, the first `part` of the node's work
  /// is done at the latest.
  Nanoseconds finish(int node, Nanoseconds part, Nanoseconds blocking, Since since = Since::occurrence) const;
  /// What goes into finish() besides the latest release and the work itself.
  FinishBreakdown breakdown(int node, Nanoseconds part, Since since = Since::occurrence) const;
  /// The thread of lower priority that blocks the node longest.
  int blocking_thread(int node) const;
  int node_of(int transaction, int task) const {
    return nodes_of_[static_cast<std::size_t>(transaction)][static_cast<std::size_t>(task)];
  }
  const BusyWindows& windows() const { return windows_; }
  /// Its numbers are known: nobody is asked whether to stop any more.
  void go_on() { windows_.go_on(); }

 private:
  void precede(const AnalysisContext& context, int node, std::vector<Transaction>& transactions) const;
  void exclude(int node, bool done_before_next, bool in_turn);
  template <class JobsOf>
  Nanoseconds work_of_thread(int thread, const JobsOf& jobs_of) const;
  Nanoseconds burst(int thread, const std::vector<NodeTimes>& nodes, bool done_before_next) const;
  bool pauses(int thread) const;

  AnalysisContext context_;
  BusyWindows windows_;
  std::vector<int> task_;                     // by node
  std::vector<std::vector<int>> nodes_of_;    // by transaction and task
  std::vector<std::vector<int>> threads_on_;  // by processor
  std::vector<std::vector<int>> nodes_on_;    // by processor
  std::vector<Nanoseconds> burst_;            // by thread
  Order order_;
  std::vector<std::vector<int>> never_together_;  // by node
  std::vector<bool> done_before_next_;            // by thread, as it was told
  std::vector<bool> in_turn_;                     // by source, as it was told
  std::vector<bool> pauses_;  // by thread: if it goes on by itself, it surely has to wait in each round
};

/// A block that is cancelled finishes what it has begun, as do its own: how long that may take.
Nanoseconds stops_within(const Problem& problem, const BusyWindows& windows, int block);

}  // namespace pal::analyzer::compositional
