// Which segment makes which run: trees of causes, one for each thing that begins by itself.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "analyzer/compositional/segment.hpp"

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

/// Whether a block comes to its end, if it does, without going round: what it does is bounded by what it
/// waits for.
bool ends_straight(const Problem& problem, int block);

/// Why nothing can be said of a skill: in words for the reader, or nothing.
std::string refusal_of(const Problem& problem, const Segments& segments);

/// Where a request is not in turn: in words for the reader, or nothing. Else each is sent only when the
/// answer to the one before has been taken, or given up, by the same thread, and is answered once, before its
/// server takes the next. So an answer that is taken is that to the last request, and neither finds its slot
/// full.
std::string out_of_turn(const Problem& problem, const Segments& segments);

/// By channel of requests: whether one may be withdrawn before it is taken, by who gives up waiting for the
/// answer or is cancelled.
std::vector<bool> withdrawn_requests(const Problem& problem);

/// The waits that may take the answer to what `send` asks for.
std::set<int> takers_of_answer(const Problem& problem, int send);

/// Whether a segment may run more than once in the life of a skill, whatever causes it.
bool recurrent(const Problem& problem, const Beginning& beginning);

/// Least time between two beginnings of a segment of one thread.
Nanoseconds least_round(const Problem& problem, const Beginning& beginning);

/// Whether a thread that goes on by itself, with rounds that begin so, surely has to wait when it comes home:
/// it gives up only after some time, or is there sooner after each request than the answer can be. It
/// need not keep up with others for that: what it asks, it asks while it has its processor. `owned`: its
/// steps.
bool waits_at_home(const Problem& problem, const Beginning& round, const std::vector<bool>& owned);

/// Least time between two effects of the steps `at` of one thread, by the shortest way; 0: its blocks begin
/// again and again.
Nanoseconds least_way(const Problem& problem, int thread, const std::vector<bool>& at);

/// A message needs at least this from its put to where `receiver` can take it, and at most this.
Range latency(const Problem& problem, int channel, int sender, int receiver);

}  // namespace pal::analyzer::compositional
