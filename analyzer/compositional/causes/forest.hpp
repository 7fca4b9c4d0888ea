// Which segment makes which run: trees of causes, one for each thing that begins by itself.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "analyzer/compositional/causes/segment.hpp"

namespace pal::analyzer::compositional {

/// Where a chain of causes begins: an event of a device, the start of a module, a round of a thread that goes
/// on by itself, or the end of blocks of which nobody knows when they end.
struct Source {
  enum class Kind { event, start, loop, joined };
  Kind kind = Kind::start;
  int device = -1;         // event
  int thread = -1;         // start, loop, joined
  int segment = -1;        // loop: the one that each round begins with
  int fork = -1;           // joined
  Nanoseconds period = 0;  // least distance of occurrences, but for the jitter; never: there is one
  Nanoseconds jitter = 0;  // occurrence k is released up to so long after its nominal instant
  bool regular = false;    // nominal instants are exactly a period apart
  std::vector<int> roots;  // nodes
  /// Sends and waits that lead to the next round of a loop.
  struct Feed {
    int node = -1;
    std::vector<int> sends;
    int wait = -1;  // that gives up
    int device = -1;
  };
  std::vector<Feed> feeds;
};

/// A segment run on behalf of its source; at most once for each of its occurrences.
struct Node {
  enum class Release { root, message, limit, fork };
  Release release = Release::root;
  int segment = -1;
  int source = -1;
  int cause = -1;          // node
  int cause_step = -1;     // limit: the wait; fork: the fork
  std::vector<int> sends;  // message: by which it comes, one of them in each run of the cause
  int device = -1;         // message: the device that was asked in between
  int depth = 0;
  std::vector<int> effects;  // nodes whose cause this is
};

struct Forest {
  Segments segments;
  std::vector<Source> sources;
  std::vector<Node> nodes;  // a cause stands before its effects
  /// Why there is no forest: in words for the reader, or nothing.
  std::string refusal;
  /// By channel: withdrawn_requests().
  std::vector<bool> withdrawn;

  explicit Forest(const Problem& problem) : segments(problem) {}
  const Segment& segment_of(const Node& node) const { return segments[node.segment]; }
  int thread_of(int node) const {
    return segments[nodes[static_cast<std::size_t>(node)].segment].beginning.thread;
  }
  /// The nearest node of `thread` among the causes of `node`; -1: there is none.
  int cause_in(int node, int thread) const;
};

/// Once `stop` says so, the forest is refused as it is.
Forest forest_of(const Problem& problem, const std::function<bool()>& stop);

/// Whether a segment has nothing more to do once one of its sends is over.
bool end_segment(const Problem& problem, const std::vector<int>& sends);

/// Whether the node's cause has nothing more to do once it has brought the node about.
bool ends_with_cause(const Problem& problem, const Forest& forest, int node);

/// A message needs at least this from its put to where `receiver` can take it, and at most this.
Range latency(const Problem& problem, int channel, int sender, int receiver);

}  // namespace pal::analyzer::compositional
