// How each thread spends its life: rounds that begin at one wait, its home.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "analyzer/compositional/causes/forest.hpp"

namespace pal::analyzer::compositional {

struct ThreadBehaviour {
  int idle_wait = -1;           // the wait at which its rounds begin and end; -1: it has no rounds
  std::vector<int> job_starts;  // nodes with which a round begins
  std::vector<int> nodes;       // all
  bool one_job = false;         // each occurrence of their one source begins one of them at most
  bool waits_within = false;    // a round waits for something before it ends
  bool leaves = false;          // a round may end elsewhere, the skill going on
  bool may_be_cancelled = false;
  bool asked_by_one =
      false;  // all rounds answer the requests of one client, which asks again only afterwards
  /// Why nothing is known of when it goes on; empty if it is.
  std::string unbounded_reason;
};

struct StartEnding {
  int node;  // may end the skill, or its thread
  int own;   // the last of the thread's nodes on the way to it, or the node itself
};

struct ThreadBehaviours {
  std::vector<ThreadBehaviour> threads;
  /// By node: the node that began its round, or the thread.
  std::vector<int> job_start;
  /// By node: the nodes of its thread after which it comes; none for those that begin rounds or threads.
  std::vector<std::vector<int>> previous;
  /// By node: it comes before its thread, which begins once, can have begun a round. Trouble with rounds is
  /// none there.
  std::vector<bool> early;
  /// By node: the message that begins its round is there when it is put, and while the slot is full the
  /// node's thread has something to do, but for its own waits for slots. So who waits for the slot does not
  /// keep the thread waiting.
  std::vector<bool> drains;
  std::vector<std::vector<int>> alternatives;  // alternatives_of()
  /// By source: nodes that may end the skill, or their thread. What waits for them to go on waits until then.
  std::vector<std::vector<int>> endings;
  /// By thread: those of the skill's start that come of it.
  std::vector<std::vector<StartEnding>> start_endings;
  std::vector<bool>
      never_full;  // by channel: the protocol of request and answer keeps its slot free for a put
};

/// Whether a node belongs to one of its thread's rounds, not to what the thread does before them.
bool in_job(const Forest& forest, const ThreadBehaviours& behaviours, int node);

/// Once `stop` says so, it is of no use.
ThreadBehaviours thread_behaviours_of(const Problem& problem, const Forest& forest,
                                      const std::function<bool()>& stop);

}  // namespace pal::analyzer::compositional
