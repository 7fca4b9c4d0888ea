// How each thread behaves: it waits at its idle wait, does a job, and returns there.
//
// A job of a thread is what it does from one message, or time-out, at its idle wait until it is back there.
// It consists of one or more segments (nodes of the forest), each a task of the busy windows.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "analyzer/compositional/causes/forest.hpp"

namespace pal::analyzer::compositional {

struct ThreadBehaviour {
  StepId idle_wait{};              // the wait at which its jobs begin and end; none: it has no jobs
  std::vector<NodeId> job_starts;  // first nodes of its jobs
  std::vector<NodeId> nodes;       // all
  bool one_job = false;            // each occurrence of their one source begins at most one job
  bool waits_within = false;       // a job waits for something before it ends
  bool leaves = false;             // a job may end away from the idle wait while the skill goes on
  bool may_be_cancelled = false;
  bool asked_by_one = false;  // all jobs serve one client, which sends its next request after the answer
  /// Why its times are unbounded; empty if they are bounded.
  Why unbounded_reason;
};

struct StartEnding {
  NodeId node;  // may end the skill or its thread
  NodeId own;   // the last of the thread's nodes on the way to it, or the node itself
};

struct ThreadBehaviours {
  Table<ThreadId, ThreadBehaviour> threads;
  /// By node: the first node of its job, or of its thread if that has no jobs.
  Table<NodeId, NodeId> job_start;
  /// By node: its predecessors in its thread. Nodes that begin a job or a thread have none.
  Table<NodeId, std::vector<NodeId>> previous;
  /// By node: it runs before the first job of its thread, which begins once. What makes jobs unbounded does
  /// not concern it.
  Table<NodeId, bool> early;
  /// By node: the message that begins its job has no latency. While its slot is full the thread is busy or
  /// itself blocked in a send. So a sender that is blocked on the slot does not delay the thread.
  Table<NodeId, bool> drains;
  std::vector<std::vector<NodeId>> alternatives;  // alternatives_of()
  /// By source: nodes that may end the skill or their thread. What depends on them waits until that end.
  Table<SourceId, std::vector<NodeId>> endings;
  /// By thread: the endings that the thread causes before any job.
  Table<ThreadId, std::vector<StartEnding>> start_endings;
  Table<ChannelId, bool>
      never_full;  // by channel: requests and answers alternate, so its slot is free at each put
};

/// Whether a node belongs to a job of its thread. What a thread does before its first job does not.
bool in_job(const Forest& forest, const ThreadBehaviours& behaviours, NodeId node);

/// Must not be used after `stop` has returned true.
ThreadBehaviours thread_behaviours_of(const Problem& problem, const Forest& forest,
                                      const std::function<bool()>& stop);

}  // namespace pal::analyzer::compositional
