// A skill in its environment as one flat, validated model: what every analysis starts from
// (docs/reference/execution-model.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "analyzer/problem/ids.hpp"
#include "analyzer/problem/limit.hpp"
#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"
#include "pal/support/table.hpp"
#include "pal/support/time.hpp"

namespace pal::analyzer {

/// Nanoseconds; analyses count in plain integers.
using Nanoseconds = std::int64_t;

/// Closed range of nanoseconds. `worst` may be unbounded (a sporadic event); nothing else ever is.
struct Range {
  static constexpr Nanoseconds unbounded = INT64_MAX / 4;
  Nanoseconds best = 0;
  Nanoseconds worst = 0;

  friend bool operator==(const Range&, const Range&) = default;
};

/// One statement of a thread, or a place where the flow of threads splits or ends. REPEAT, END CASE and
/// others that take no time are removed: `next` leads past them. The body of an Execute stands in its place.
struct Step {
  enum class Kind { wait, send, set, read, test, activity, complete, fork, end };
  Kind kind = Kind::end;
  StatementId statement{};
  CallId call{};       // the Execute whose body this stands in
  Range cost;          // of a wait: of its receive
  Range give_up_cost;  // wait with a limit: of the test that gives up

  /// wait: in the order of preference; send: the one. A wait without (only in slices) is over at any time,
  /// or at once, and goes on with any of `next`.
  std::vector<ChannelId> channels;
  std::optional<Nanoseconds> within;  // wait
  /// Only in slices, for a wait for a party that is left out: the time after reaching it within which a
  /// message comes. For a send to one: within the greatest the slot is free.
  Range arrival{0, Range::unbounded};
  /// Only in slices, for a wait: comes once, before its module has blocks. So no answer that is
  /// received there is withdrawn.
  bool before_blocks = false;
  ConditionId condition{};         // set, read
  std::vector<KeptId> uses;        // what an activity reads, a set is computed from, a send sends
  std::vector<KeptId> writes;      // what an activity writes
  std::optional<bool> value;       // set
  int code = 0;                    // complete
  std::vector<pan::Guard> guards;  // test: without a guard that holds, next[guards.size()], if there is one
  std::vector<ThreadId> threads;   // fork: the blocks
  /// Steps that follow:
  /// - wait: one for each channel, then ELSE;
  /// - test: one for each guard, then where none holds (absent: the skill ends with its error completion);
  /// - fork: after END CONCURRENT;
  /// - complete, end: none.
  std::vector<StepId> next;
};

struct Thread {
  std::string name;
  pan::ModuleId module{};  // whose channels it uses
  ProcessorId processor{};
  int priority = 0;
  ThreadId parent{};      // of a block: the thread of its CONCURRENT
  bool can_end = true;    // its flow can reach its end
  StepId entry{};         // first step
  bool left_out = false;  // only in slices: it never begins
};

struct Channel {
  DeviceId sender_device{};    // none: a module sends
  DeviceId receiver_device{};  // none: a module receives
  pan::ModuleId sender_module{};
  pan::ModuleId receiver_module{};
  ChannelId answer{};                            // of a request: channel of its answer
  ChannelId answers{};                           // of an answer: channel of the request
  bool served = false;                           // a request that its device answers
  std::vector<ProcessorId> receiver_processors;  // of the threads that wait for it
  std::string message;
  KeptId kept{};  // the thread that takes the message leaves it there; none: no thread uses it
  /// Only in slices: the party at one of its ends is left out. Its messages may come and go at any time.
  bool loose = false;
  bool withdrawable = false;  // loose: what a thread is about to take may be withdrawn
};

struct Device {
  std::string name;
  std::variant<std::monostate, pan::EventDevice, pan::RequestDevice, pan::FrameDevice> behaviour;
  ChannelId event{};                // event device: the channel of its event; none: no thread waits for it
  std::vector<ChannelId> requests;  // on request, frames: channels of what it serves
  bool seldom = false;              // frames, only in slices: they start a period or more apart
};

struct Statement {
  std::string module;
  std::string text;  // canonical PAL
  std::string file;
  int line = 0;
  SourceSpan where;
  pan::ModuleId source_module{};
  pan::NodeId source_node{};
};

/// A REPEAT of a module.
struct ProgramLoop {
  pan::ModuleId module{};
  pan::NodeId repeat{};
  pan::NodeId until{};
  std::string file;
  int line = 0;
  SourceSpan where;
};

/// An Execute that one thread runs, at one place of its flow.
struct Call {
  pan::ModuleId source_module{};  // where the Execute stands
  pan::NodeId source_node{};
  CallId outer{};  // the call in whose body that is
};

/// The value of a message that a module, with those that it executes, keeps for its statements.
struct Kept {
  pan::ModuleId module{};
  pan::MessageId message{};
};

/// The part of a run that counts (docs/reference/timing.md). Without steps it is the whole run.
struct Phase {
  Table<StepId, bool> after;   // from when one of these is first done
  Table<StepId, bool> during;  // while a thread is at one of these
  std::string text;            // "after TXM( motion to MC1 ) in SM1"

  bool limits() const { return !after.empty() || !during.empty(); }
};

/// A requirement, its statements as a set of steps.
struct Requirement {
  enum class Measure { age, response, load, reaction, interval, loss, duration, busy };
  std::string name;
  Measure measure = Measure::age;
  ConditionId condition{};         // age, reaction: of a condition
  std::vector<ChannelId> samples;  // age, reaction: of a device: its channels
  std::vector<ChannelId> events;   // response: channels, of one message from one party
  DeviceId device{};               // loss, and of samples: the device; response: the device, if one sends
  Table<StepId, bool> at;          // age, response, reaction, interval
  Phase phase;
  std::vector<ProcessorId> processors;  // load, busy
  int in = 1;                           // loss: at most `limit` of this many in a row
  int code = 0;                         // duration: of the completion
  bool at_least = false;                // interval: `limit` is the least that is allowed
  Nanoseconds limit = 0;                // loss: a number
  SourceSpan where;

  /// What is allowed, with its unit.
  Limit allowed() const;

  /// Response: whether the messages of the channel are what is responded to.
  bool is_event(ChannelId channel) const;
};

/// The unit of what is measured.
Figure::Unit unit_of(Requirement::Measure measure);

/// The threads that set a condition.
struct Setters {
  ProcessorId processor;  // on which all of them run; none: there is no such one
  Table<ThreadId, bool> threads;
};

struct Problem {
  std::string skill;
  std::string environment;
  Table<ProcessorId, pan::Processor> processors;
  Table<ThreadId, Thread> threads;  // a block stands behind its parent
  Table<StepId, Step> steps;
  Table<ChannelId, Channel> channels;
  Table<DeviceId, Device> devices;
  Table<ConditionId, std::string> conditions;
  Table<StatementId, Statement> statements;
  Table<CallId, Call> calls;
  Table<LoopId, ProgramLoop> loops;  // of all modules
  Table<KeptId, Kept> kept;
  std::vector<Requirement> requirements;
  Range within_processor;    // latency of a message to a thread on the sender's processor
  Range between_processors;  // and to one on another
  Table<pan::ModuleId, std::string> module_names;
  int error_code = 2;  // of the first error completion
  std::vector<ProcessorId>
      overloaded;  // processors that have more to do for events than there is time (PAL0820)
  std::uint64_t free_conditions = 0;    // by bit, only in slices: their reads give any value
  Table<ConditionId, Setters> setters;  // of these; only in slices
};

/// Name of the device or module that sends on the channel, or to which it leads.
const std::string& sender_name(const Problem& problem, ChannelId channel);
const std::string& receiver_name(const Problem& problem, ChannelId channel);

/// Whether a step stands in a loop, or in what is executed there.
bool is_in(const Problem& problem, StepId step, LoopId loop);

/// The loop that a thread is in at a step, the innermost of several; none: it is in none.
LoopId innermost_loop(const Problem& problem, StepId step);

/// Builds the model of `network` in `environment`. Reports everything in the environment that is missing,
/// unknown or impossible (PAL072x), and requirements that make no sense (PAL081x). After such an error there
/// is no model. `sources` gives statements their file and line; without it they have none.
std::optional<Problem> make_problem(const pan::Network& network, const pan::Environment& environment,
                                    Diagnostics& diagnostics, const SourceManager* sources = nullptr);

/// Whether the problem is small enough for the exact analysis: 100 threads, 120 channels.
bool fits_exploration(const Problem& problem);

/// Whether single runs can be made of it: 2,000 threads, 4,000 channels, 128 requests of a device.
bool fits_simulation(const Problem& problem);

}  // namespace pal::analyzer
