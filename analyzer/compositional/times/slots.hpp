// Two assumptions of the times: slots are free when messages are put, and threads are idle when they are due.
#pragma once

#include "analyzer/compositional/causes/exclusive.hpp"
#include "analyzer/compositional/times/times.hpp"

namespace pal::analyzer::compositional {

/// Whether the node's message is received before the next one is put, at `put` at the earliest.
bool take_in_time(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes, NodeId node,
                  Nanoseconds put);

/// Whether each job of a thread is done before the next one is requested. The thread may still be blocked in
/// its last send.
bool is_done_before_next(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes,
                         ThreadId thread);

/// Latest end of a send by which the node comes straight to `wait`; 0: there is none.
Nanoseconds sent_before(const AnalysisContext& context, const NodeTimes& times, NodeId node, StepId wait);

/// Until when a send may be blocked on its slot: the previous message is received a period earlier than its
/// own.
Nanoseconds held_until(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes, NodeId node,
                       StepId send);

class Slots {
 public:
  explicit Slots(const AnalysisContext& context);

  struct UnboundedThread {
    ThreadId thread{};
    bool blocked = false;  // it may be blocked in a send
    Why why;
    std::vector<ThreadId> takers;  // the receivers that may not empty its slot
  };
  /// The threads that are unbounded by these times.
  std::vector<UnboundedThread> unbounded_threads(const Times& times) const;

 private:
  bool is_free(const Table<NodeId, NodeTimes>& nodes, ChannelId channel) const;
  bool is_taken_in_time(const Table<NodeId, NodeTimes>& nodes, StepEffect put, Nanoseconds soonest,
                        bool may_hold) const;
  std::vector<ThreadId> takers_of(StepEffect put) const;
  bool may_be_held(const Table<NodeId, NodeTimes>& nodes, StepEffect put, NodeId taker) const;

  AnalysisContext context_;
  Table<ChannelId, std::vector<StepEffect>> puts_;  // by channel
  Table<ChannelId, bool> exclusive_;                // by channel: are_exclusive() of its puts
};

}  // namespace pal::analyzer::compositional
