// Which segment triggers which: a tree of causes for each source of activations.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "analyzer/compositional/causes/segment.hpp"
#include "analyzer/compositional/causes/withheld.hpp"

namespace pal::analyzer::compositional {

/// The source of a chain of causes. It is an event of a device, the start of a module, a job of a
/// free-running thread, or the end of blocks that end at an unknown time.
struct Source {
  enum class Kind { event, start, loop, joined };
  Kind kind = Kind::start;
  DeviceId device{};          // event
  ThreadId thread{};          // start, loop, joined
  SegmentId segment{};        // loop: the first segment of each job
  StepId fork{};              // joined
  Nanoseconds period = 0;     // least inter-arrival time without the jitter; never: it occurs once
  Nanoseconds jitter = 0;     // latest release of an occurrence after its nominal instant
  bool regular = false;       // nominal instants are exactly a period apart
  std::vector<NodeId> roots;  // nodes
  /// Sends and time-outs that trigger the next job of a loop.
  struct Feed {
    NodeId node{};
    std::vector<StepId> sends;
    StepId wait{};  // that times out
    DeviceId device{};
  };
  std::vector<Feed> feeds;
};

/// A segment triggered by its source: at most once for each occurrence of the source.
struct Node {
  enum class Release { root, message, limit, fork };
  Release release = Release::root;
  SegmentId segment{};
  SourceId source{};
  NodeId cause{};             // node
  StepId cause_step{};        // limit: the wait; fork: the fork
  std::vector<StepId> sends;  // message: the sends that trigger it; each run of the cause passes one of them
  DeviceId device{};          // message: the device that answers in between
  int depth = 0;
  std::vector<NodeId> effects;  // nodes whose cause this is
};

struct Forest {
  Segments segments;
  Table<SourceId, Source> sources;
  Table<NodeId, Node> nodes;  // a cause stands before its effects
  /// Why there is no forest; empty if there is one.
  Why refusal;

  SetAside set_aside;

  explicit Forest(const Problem& problem) : segments(problem) {}
  /// Whether a bound is withheld for this reason.
  bool withholds(Withheld withheld) const { return !set_aside.has(withheld); }
  bool withholds(const Why& why) const { return why.withheld && withholds(*why.withheld); }
  const Segment& segment_of(const Node& node) const { return segments[node.segment]; }
  ThreadId thread_of(NodeId node) const { return segments[nodes[node].segment].beginning.thread; }
  /// The nearest node of `thread` among the causes of `node`, if there is one.
  NodeId cause_in(NodeId node, ThreadId thread) const;
};

/// Refused as interrupted once `stop` returns true.
Forest forest_of(const Problem& problem, const std::function<bool()>& stop, const SetAside& set_aside = {});

/// Whether each of these sends ends its segment.
bool end_segment(const Problem& problem, const std::vector<StepId>& sends);

/// Whether the node's cause ends with the step that triggers the node.
bool ends_with_cause(const Problem& problem, const Forest& forest, NodeId node);

/// The least and greatest time from the put of a message until `receiver` can receive it.
Range latency(const Problem& problem, ChannelId channel, ThreadId sender, ThreadId receiver);

}  // namespace pal::analyzer::compositional
