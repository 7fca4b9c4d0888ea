// A file of PAL as it was written: what stands where, before any name is looked up.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/source.hpp"
#include "pal/support/time.hpp"
#include "pal/syntax/statement.hpp"

namespace pal::syntax {

/// USES "file.pal"
struct Uses {
  std::string path;  // as written
  SourceSpan where;  // of the text between and with the quotes
  FileId file{};     // what read_sources() found under it; invalid before, or if there is none
};

/// MESSAGE name : fields
struct MessageUnit {
  Name name;
  std::vector<pan::Field> fields;
  std::vector<Name> field_names;  // in the order of fields; empty if the one field has no name of its own
  SourceSpan where;
};

/// CONDITION name FROM messages "description"
struct ConditionUnit {
  Name name;
  std::vector<Name> from;
  std::string description;
  SourceSpan where;
};

/// DEVICE name "description"
struct DeviceUnit {
  Name name;
  std::string description;
  SourceSpan where;
};

/// ACTIVITY name READS messages WRITES messages TIME interval
struct ActivityHeading {
  Name name;
  std::vector<Name> reads;
  std::vector<Name> writes;
  SourceSpan where;
  std::optional<Interval> time{};
};

/// A slot of a template that lists names: SENSOR DRIVER SD1, SD2; or NONE.
struct NameSlot {
  std::vector<Name> names;
  SourceSpan where;
};

/// What the template of a logical sensor says beside its description (thesis, section 2.3.5).
struct SensorTemplate {
  std::optional<NameSlot> drivers;
  std::vector<std::string> methods;
  std::optional<NameSlot> returns;
  SourceSpan where;  // of the first slot; invalid if there is none
};

/// Kind: name … BEGIN … END
struct ModuleUnit {
  pan::ModuleKind kind = pan::ModuleKind::skill_module;
  Name name;
  std::vector<std::string> descriptions;
  std::vector<ActivityHeading> activities;
  SensorTemplate sensor;
  bool has_body = false;
  Statements body;
  SourceSpan where;  // from the kind to the name
  SourceSpan end;    // the last END
  SourceSpan whole{};
};

struct Contingency {
  int number = 0;
  std::string description;
  std::optional<Name> method;
  SourceSpan where;
  SourceSpan number_where{};
};

/// A value of a parameter: 20, 2 cm/s, TRUE, "park".
struct Literal {
  std::string digits;  // of a number, as written; empty: TRUE or FALSE, or a text
  double value = 0;    // TRUE: 1
  std::string unit;    // as written, without spaces; empty: none is given
  SourceSpan where;
  std::optional<std::string> text = std::nullopt;  // of a text
};

struct Parameter {
  Name name;
  pan::ScalarType type = pan::ScalarType::real;
  bool location = false;  // a text: a name of a location that is taught
  std::string unit;
  std::optional<Literal> default_value;
  std::optional<Literal> low;
  std::optional<Literal> high;
  std::string description;
  SourceSpan where;
};

struct Completion {
  int code = 0;
  pan::Completion::Kind kind = pan::Completion::Kind::normal;
  int contingency = 0;
  std::string description;
  SourceSpan where;
  SourceSpan code_where{};
  SourceSpan contingency_where{};  // invalid: it names none
};

/// Every statement of this form; of one module only, if one is named.
struct Step {
  enum class Kind { wait, send, set, read, perform };
  Kind kind = Kind::send;
  MessageName message;        // wait, send
  PartyName party;            // wait: the sender; send: the receiver
  Name name;                  // set, read: the condition; perform: the activity
  std::optional<bool> value;  // set: only those to this value; without it all
  std::optional<PartyName> in;
  SourceSpan where;
};

/// What an age or a reaction is of: a condition, or what a device measures.
struct Known {
  struct Sample {
    MessageName message;
    PartyName from;
  };
  std::variant<Name, Sample> of;
};

/// The part of each run that a requirement is about. It is what comes after a statement, or the time in which
/// a thread is in the innermost loop around one.
struct Phase {
  enum class Kind { after, during };
  Kind kind = Kind::after;
  Step step;
  SourceSpan where;
};

struct Requirement {
  struct Response {
    MessageName event;
    PartyName of;
    Step to;
  };
  struct Age {
    Known of;
    Step at;
  };
  struct Reaction {
    Known of;
    Step at;
  };
  /// AT MOST, AT LEAST, or both (BETWEEN).
  struct Passes {
    Step at;
    std::optional<Duration> least;
    std::optional<Duration> most;
  };
  struct Loss {
    PartyName of;
    int most = 0;
    int in = 1;
    std::optional<Duration> share = {};  // if `most` is written as a percentage: of a second, as a load
  };
  struct Completing {
    int code = 0;
    SourceSpan where;
  };
  struct Load {
    std::optional<Name> processor;
  };
  struct BusyPeriod {
    std::optional<Name> processor;
  };
  Name name;
  std::variant<Response, Age, Reaction, Passes, Loss, Completing, Load, BusyPeriod> measure;
  Duration limit{};  // of a load: nanoseconds of work in a second; of passes and losses: nothing
  std::optional<Phase> phase;
  SourceSpan where;
};

/// SKILL name … END SKILL: the generic skill template (thesis, section 2.3.2).
struct SkillUnit {
  Name name;
  std::vector<std::string> descriptions;
  std::vector<std::string> preconditions;
  std::vector<std::string> postconditions;
  std::vector<std::string> model_data;
  std::vector<Name> sensor_drivers;
  std::vector<Name> machine_controllers;
  std::vector<Name> logical_sensors;
  std::vector<Name> skill_methods;
  std::vector<Contingency> contingencies;
  std::vector<Parameter> parameters;
  std::vector<Completion> completions;
  std::vector<Requirement> requirements;
  SourceSpan where;  // SKILL and the name
  SourceSpan whole{};
};

/// COST SEND 0.05 ms, LATENCY WITHIN PROCESSOR 0 ms
struct CostItem {
  enum class Kind { send, receive, set, read, test, latency_within, latency_between };
  Kind kind = Kind::send;
  Interval time;
  SourceSpan where;
};

/// SENSOR DRIVER, LOGICAL SENSOR, MACHINE CONTROLLER and GENERIC SKILL of an environment; a slot that is not
/// given says nothing.
struct Resources {
  std::optional<NameSlot> sensor_drivers;
  std::optional<NameSlot> logical_sensors;
  std::optional<NameSlot> machine_controllers;
  std::optional<NameSlot> skills;
};

/// A name in an item of an environment.
struct ItemName {
  enum class Role {
    processor,  // PROCESSOR P0: declares it
    placed_on,  // … ON P0
    device,     // DEVICE alter: a device, or a module without a body
    message,    // of an event or its answer
    thread,     // PLACE SM1.2: the module
    activity,   // TIME extract-z
    owner       // … OF LS1
  };
  Role role = Role::processor;
  Name name;
  SourceSpan item;
  std::string owner{};  // activity: the module that OF names; empty: any
};

/// ENVIRONMENT name … END ENVIRONMENT. Its parts need no names looked up, and are what pan::Environment
/// holds. `names` are those in the items, for those who look them up all the same.
struct EnvironmentUnit {
  Name name;
  std::vector<std::string> descriptions;
  Resources resources;
  std::vector<pan::Processor> processors;
  std::vector<pan::DeviceTiming> devices;
  std::vector<pan::Placement> placements;
  std::vector<pan::ActivityTime> activities;
  std::vector<CostItem> costs;
  SourceSpan where;  // ENVIRONMENT and the name
  SourceSpan whole{};
  std::vector<ItemName> names{};  // in the order of the text
};

using Unit =
    std::variant<Uses, MessageUnit, ConditionUnit, DeviceUnit, ModuleUnit, SkillUnit, EnvironmentUnit>;

/// One file. `complete` is false if there were syntax errors: then parts of the text are not in the tree.
/// Figures that mean nothing (1.5 ns) leave it complete, with nothing in their place.
struct Tree {
  FileId file{};
  bool complete = true;
  bool lost = false;        // after syntax errors: lines may be missing, or have another meaning
  std::vector<Unit> units;  // in the order of the text
};

}  // namespace pal::syntax
