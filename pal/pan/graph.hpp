// The body of one module as a graph: a Process Activity Network (thesis, figures 3.4 and 3.5).
//
// The graph is structured. Every node that splits the flow names its mate, the node where the flow comes
// together again. So the program text can be recovered from the graph.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "pal/pan/ids.hpp"
#include "pal/support/source.hpp"
#include "pal/support/time.hpp"

namespace pal::pan {

/// A test over conditions: one condition against a value, or a combination of tests.
struct Guard {
  enum class Kind { equals, all_of, any_of, negation };
  Kind kind = Kind::equals;
  ConditionId condition{};   // equals
  bool value = true;         // equals
  std::vector<Guard> terms;  // all_of, any_of: two or more; negation: one

  friend bool operator==(const Guard&, const Guard&) = default;
};

// Node contents. `out` below lists the successors that each has.

/// Where the module begins. out: first statement.
struct Start {};
/// Where the module, or a block of CONCURRENT, ends. out: none.
struct End {};
/// WTM( Coordinator ): takes the start of the skill. out: next.
struct WaitForStart {};
/// WTM: takes a message from the first of `channels` that has one. With one channel and no `within`: out is
/// the next statement and there is no mate. Otherwise out[i] is the branch of channels[i], followed by the
/// ELSE branch if `within` is given; mate is the Merge. `within` counts from reaching the statement; 0 only
/// looks.
struct Wait {
  std::vector<ChannelId> channels;
  std::optional<Duration> within;
};
/// TXM: puts a message into the channel's one slot, blocking while it is full. out: next.
struct Send {
  ChannelId channel;
};
/// TXM( Completion Protocol n ): ends the skill. out: next (never reached in time).
struct Complete {
  int code = 0;
};
/// SPC: sets the condition to `value`, or to what the module computes. out: next.
struct Set {
  ConditionId condition;
  std::optional<bool> value;
};
/// RPC: latches the condition's value for the next test. out: next.
struct Read {
  ConditionId condition;
};
/// A named activity. out: next.
struct Perform {
  ActivityId activity;
};
/// Execute M: runs the body of module M in the caller's place and time. out: next.
struct Execute {
  ModuleId module;
};
/// Do Nothing. out: next.
struct Nothing {};
/// CASE: takes the first arm whose guard holds. If none does, the skill ends with its error completion.
/// out[i]: first node of the arm of guards[i]; mate: Merge.
struct Choose {
  std::vector<Guard> guards;
};
/// END CASE, END WTM. out: next; mate: the Choose or Wait.
struct Merge {};
/// REPEAT. out: first node of the body; mate: Until.
struct Loop {};
/// UNTIL. Without a guard: forever, and nothing follows. With one, out: the statement after the loop.
/// mate: the Loop, to which the flow returns while the guard does not hold.
struct Until {
  std::optional<Guard> guard;
};
/// CONCURRENT. out[i]: first node of block i, which runs to an End of its own; mate: Join.
/// threads[i]: index of block i's thread in Module::threads.
struct Fork {
  std::vector<std::size_t> threads;
};
/// END CONCURRENT. out: next; mate: Fork. The flow gets here when every block that can end has ended.
struct Join {};

using Content = std::variant<Start, End, WaitForStart, Wait, Send, Complete, Set, Read, Perform, Execute,
                             Nothing, Choose, Merge, Loop, Until, Fork, Join>;

struct Node {
  Content content;
  std::vector<NodeId> out;
  NodeId mate{};
  SourceSpan where;  // the statement in the PAL text
};

/// Nodes in the order of the text. nodes[0] is the Start; a module without a body has no nodes.
struct Graph {
  std::vector<Node> nodes;

  bool empty() const { return nodes.empty(); }
  const Node& operator[](NodeId id) const { return nodes[id.index()]; }
};

}  // namespace pal::pan
