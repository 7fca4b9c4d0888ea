// The modules of a skill as communicating automata: their bodies reduced to messages and conditions.
// Activities, Do Nothing and everything that only joins flow are left out. The exception is work before the
// end of a block that may cancel others, because these go on for that long. An executed module occurs once
// for each place that executes it, and its blocks once for each thread that does.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pal/check/conditions/guards.hpp"
#include "pal/check/deadlock/threads.hpp"
#include "pal/pan/flow.hpp"
#include "pal/pan/network.hpp"

namespace pal::check::deadlock {

/// One step of a thread. `next` are the steps that can follow, in the order of the text.
struct Step {
  enum class Kind {
    wait,      // next[i]: after channels[i]; the last one, if gives_up, after giving up
    send,      // channels[0]
    complete,  // the skill ends; no next
    set,       // condition; value or both
    latch,     // condition
    test,      // next[i]: guards[i] holds; of a loop the last one: no guard holds
    enter,     // a module that is executed; passed by the thread that comes there
    fork,      // next[i]: first step of block i, then the join; passed likewise
    join,      // next[0]: when the blocks have ended or stopped; none: they never do
    end,       // of a block, or of a module
    work,      // says nothing and takes time, before the end of a block that may cancel others; next[0]
    spin,      // goes round for ever and says nothing
  };
  Kind kind = Kind::end;
  std::size_t thread = 0;
  pan::ModuleId module;
  pan::NodeId node;
  std::vector<std::size_t> next;
  std::vector<pan::ChannelId> channels;
  bool gives_up = false;
  pan::ConditionId condition{};
  std::optional<bool> value;
  std::vector<pan::Guard> guards;
  bool otherwise = false;  // test: no guard needs to hold; false: the skill ends with its error completion
  std::vector<std::size_t> blocks;  // fork: their threads
};

/// A module, or a block of CONCURRENT.
struct Thread {
  std::string name;
  pan::ModuleId module;
  std::optional<std::size_t> parent;
  std::size_t depth = 0;
  bool can_end = true;  // of a block
  std::size_t first = 0;
  std::vector<std::size_t> children;  // all blocks, of whatever CONCURRENT
};

struct Automata {
  std::vector<Thread> threads;  // the skill method's first; parents before their blocks
  std::vector<Step> steps;
  /// Of a channel: the request that it answers.
  std::vector<std::optional<pan::ChannelId>> request_of;
  /// Of a channel: the answer that it asks for.
  std::vector<std::optional<pan::ChannelId>> answer_of;
  std::vector<bool> from_device;
  std::vector<bool> to_device;
  /// Messages that the skill method sends to another module as commands: they are not requests.
  std::vector<bool> command;
  /// Conditions that some test reads and some module sets. The others are always FALSE, or have no influence.
  std::vector<std::optional<std::size_t>> bit;  // by condition
  std::size_t bits = 0;
  /// Conditions whose values are not followed: a test may find either. They have no bit.
  std::vector<bool> unknown;  // by condition
};

/// Whether other threads may be cancelled at the instant at which this thread, a block, ends. These are its
/// siblings, or those of a block that ends with it.
bool end_may_cancel(const Automata& automata, std::size_t thread);

/// Automata with more steps are too large to explore, and are incomplete.
constexpr std::size_t most_steps = 0x7ff0;

/// Every module with a body that no other module executes is a thread. Tests whose outcome makes no
/// difference are left out, with the conditions that only they read.
Automata automata(const pan::Network& network, const pan::Flow& flow);

/// The same with every condition that some module sets unknown. All runs of `automata` are runs of these,
/// which may have others.
Automata without_conditions(Automata automata);

}  // namespace pal::check::deadlock
