// A skill as C++ will have it: every name, index and table row is decided, and no text is written yet.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"
#include "pal/support/time.hpp"

namespace pal::codegen {

struct PlannedField {
  std::string name;  // C++
  std::string pal_name;
  pan::ScalarType type = pan::ScalarType::real;
  std::string unit;
  int size = 0;  // of an array; 0: a single value
};

/// A message with fields: a struct. Messages without fields need no C++.
struct PlannedMessage {
  std::string type;      // C++: "Motion"
  std::string variable;  // C++: "motion"
  std::string pal_name;
  std::vector<PlannedField> fields;
};

/// True if every field is a single number or boolean.
bool is_plain(const PlannedMessage& message);

struct PlannedParameter {
  std::string name;  // C++
  pan::Parameter pal;
};

/// A method that the system programmer writes. It is an activity, an SPC without a value, or the making of a
/// message that nothing in the module writes or takes. Messages are indices into Plan::messages.
struct PlannedMethod {
  enum class Kind { activity, decide, compose };
  Kind kind = Kind::activity;
  std::string name;
  std::string pal;  // what it comes from, for a comment
  std::string description;
  std::vector<std::size_t> reads;
  std::vector<std::size_t> writes;  // compose: the one
  std::string result_type;          // of more than one write: a struct of its own
};

/// Where a wait takes a message from, or a send puts it.
struct PlannedEnd {
  std::size_t channel = 0;             // in Plan::channels
  std::optional<std::size_t> message;  // in Plan::messages; none: without fields
};

struct PlannedStatement;
using PlannedBody = std::vector<PlannedStatement>;

struct PlannedStatement {
  enum class Kind {
    take_start,
    wait,
    send,
    complete,
    set,
    read,
    perform,
    execute,
    nothing,
    choose,
    loop,
    concurrent
  };
  Kind kind = Kind::nothing;
  std::string pal;                 // canonical spelling
  int line = 0;                    // in the PAL text; 0: unknown
  std::optional<std::size_t> row;  // in Plan::statements
  std::vector<PlannedEnd> ends;    // wait: one or more; send: one
  std::optional<Duration> within;  // wait
  std::optional<std::size_t>
      method;  // perform, set without a value, send that composes: in the module's methods
  std::optional<std::size_t> condition;  // set, read: in Plan::conditions
  std::optional<bool> value;             // set
  int code = 0;                          // complete
  std::optional<std::size_t> module;     // execute: in Plan::modules
  std::vector<pan::Guard> guards;        // choose: one a branch; loop: the UNTIL's one, or none
  std::vector<std::string> arms;         // choose, wait with branches: the head of each branch as PAL has it
  std::vector<PlannedBody> branches;     // choose, wait with branches, concurrent; loop: one
  /// concurrent: of each branch its threads, in Plan::threads, one for each thread that begins it.
  std::vector<std::vector<std::size_t>> threads;
  std::optional<std::size_t> loop;  // loop: if a phase of a requirement names it, its number
  pan::NodeId pan_node;             // loop: in the network
  std::string until;                // loop: the UNTIL in its canonical spelling
  int until_line = 0;
};

struct PlannedModule {
  std::string type;      // C++ class
  std::string variable;  // C++
  std::string words;     // part of identifiers
  std::string pal_name;
  std::string kind;       // "skill module"
  std::string file;       // of the PAL text
  std::string interface;  // C++ class of its methods; empty: it has none
  std::vector<PlannedMethod> methods;
  std::vector<std::size_t> messages;  // that it keeps a value of
  /// The module in whose thread it runs, if one of that thread executes another: they keep their messages
  /// together.
  std::optional<std::size_t> keeper;
  std::vector<std::size_t> executes;  // modules that it runs
  bool executed = false;              // runs in others' threads only
  std::vector<std::size_t> runners;   // executed: the threads in which it runs, in Plan::threads
  PlannedBody body;
  /// Blocks of CONCURRENT anywhere in the body, in the order of the text: member functions of their own.
  struct Block {
    std::vector<std::size_t> threads;  // that run it, in Plan::threads
    std::string function;
    std::string chooser;  // of several: the C++ function that gives the one that a thread begins
  };
  std::vector<Block> blocks;
};

/// One value of each message, for a module and all that it executes.
struct PlannedStore {
  std::string type;      // C++ struct
  std::string variable;  // C++
  std::size_t keeper = 0;
  std::vector<std::size_t> messages;
};

struct PlannedThread {
  std::string constant;  // C++
  std::string pal_name;
  std::size_t module = 0;
  std::size_t processor = 0;
  int priority = 0;
  std::optional<std::size_t> parent;  // of a block: whose CONCURRENT begins it, in Plan::threads
  std::optional<std::size_t> runner;  // of a block: which runs the body of its module
  bool can_end = true;
};

struct PlannedRow {
  std::string constant;  // C++
  std::string module;
  std::string text;
  std::string file;
  int line = 0;
  Interval cost;
  pan::ModuleId pan_module;  // in the network
  pan::NodeId pan_node;
};

/// A requirement, and the parties that its proof relies on: all that can delay what it is about.
struct PlannedRequirement {
  enum class Measure {
    response,
    age,
    sample,
    interval,
    duration,
    reaction,
    sample_reaction,
    loss,
    load,
    busy
  };
  std::string name;
  Measure measure = Measure::duration;
  Duration least{};
  std::optional<Duration> most;
  std::vector<std::size_t> channels;     // response, sample: in Plan::channels
  std::vector<std::size_t> at;           // in Plan::statements
  std::optional<std::size_t> condition;  // age, reaction
  int code = 0;                          // duration
  std::vector<std::size_t> threads;      // those that no CONCURRENT begins
  std::vector<std::size_t> devices;      // in Plan::devices
  std::optional<std::size_t> device;     // loss: in Plan::devices
  int in = 1;                            // loss
  std::vector<std::size_t> processors;   // load, busy: in the environment
  std::vector<std::size_t> after;        // of a phase: in Plan::statements
  std::vector<std::size_t> during;       // of a phase: numbers of loops
};

/// What happens to a message that a module keeps; those are numbered from 0 on.
struct PlannedKept {
  enum class How { taken, used, written };
  How how = How::taken;
  std::size_t place = 0;  // taken: in Plan::channels; otherwise in Plan::statements
  std::size_t kept = 0;
};

struct PlannedChannel {
  std::string constant;  // C++
  std::string sender;
  std::string message;
  std::string receiver;
  std::optional<std::size_t> fields;  // in Plan::messages
  std::optional<std::size_t> answer;
  bool request = false;
  bool from_device = false;
  bool to_device = false;
};

struct PlannedCondition {
  std::string constant;  // C++
  std::string pal_name;
};

/// What the author of a device derives from.
struct PlannedDevice {
  struct Port {
    std::string name;  // part of identifiers: "request_wrench"
    std::string message;
    bool to_device = false;
    std::optional<std::size_t> fields;  // in Plan::messages
  };
  std::string type;  // C++ class
  std::string pal_name;
  std::string description;
  std::vector<Port> ports;  // in the order of the channels
};

struct Plan {
  std::string name;  // C++: "touch_read_first", of the namespace and the factory
  std::string file;  // how the names of its files begin: "touch_read_first"
  std::string skill_class;
  pan::Template skill;
  std::vector<PlannedParameter> parameters;
  pan::Environment environment;
  std::vector<PlannedMessage> messages;
  std::vector<PlannedModule> modules;  // those with a body
  std::vector<PlannedStore> stores;
  std::vector<PlannedThread> threads;
  std::vector<PlannedRow> statements;
  std::vector<PlannedChannel> channels;
  std::vector<PlannedCondition> conditions;
  std::vector<std::string> devices;
  std::vector<PlannedDevice> device_classes;  // one for each of `devices`
  std::vector<PlannedRequirement> requirements;
  std::vector<PlannedKept> kept;  // as far as a requirement is about samples
};

/// Reports what the environment lacks (PAL09xx); no plan then. `network` has been checked.
std::optional<Plan> make_plan(const pan::Network& network, const pan::Environment& environment,
                              const SourceManager& sources, Diagnostics& diagnostics);

/// The whole plan as text, the same for the same plan.
void dump(const Plan& plan, std::ostream& out);

}  // namespace pal::codegen
