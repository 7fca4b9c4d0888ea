// One skill, checked, with everything that its modules name: the input of every later stage.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pal/pan/graph.hpp"
#include "pal/pan/ids.hpp"
#include "pal/pan/requirement.hpp"
#include "pal/support/source.hpp"
#include "pal/support/time.hpp"

namespace pal::pan {

/// The five kinds of module (thesis, section 3.3).
enum class ModuleKind { sensor_driver, logical_sensor, machine_controller, skill_module, contingency_module };

/// A type of one field of a message, or of a parameter.
enum class ScalarType { real, integer, boolean, text };

/// The most values of an array, and the most characters of a text: the size of a message is bounded.
constexpr int largest_array = 4096;
constexpr std::size_t longest_text = 100;

/// One field of a message. `unit` is the canonical spelling ("mm", "N", "N*m", "deg"); empty: a plain number.
struct Field {
  std::string name;
  ScalarType type = ScalarType::real;
  std::string unit;
  int size = 0;  // of an array, 1 to largest_array; 0: a single value
};

/// True if both may stand in one group of a declaration: `x, z : REAL[255] mm`.
inline bool of_one_type(const Field& a, const Field& b) {
  return a.type == b.type && a.unit == b.unit && a.size == b.size;
}

/// A message by name. A request has no fields of its own: it asks for `asks_for`.
/// The texts `request X` and `X request` both name the message "request X".
struct Message {
  std::string name;
  std::vector<Field> fields;
  MessageId asks_for{};  // valid: this is the request for that message
  SourceSpan where;
};

/// A sender or receiver: a module, or a device, the world's side of a driver.
using Party = std::variant<ModuleId, DeviceId>;

/// One slot for one message on its way from one party to another.
/// A module that is run by Execute talks as the module that executes it.
struct Channel {
  Party sender;
  MessageId message;
  Party receiver;
  ChannelId answer{};  // of a request: the channel on which the answer comes back, if there is one
  SourceSpan where;    // the first statement that uses it
};

/// A process condition: a boolean that one module sets and the skill's modules read. FALSE when the skill
/// starts.
struct Condition {
  std::string name;
  std::string description;
  ModuleId writer{};            // invalid: never set
  std::vector<MessageId> from;  // the messages that SPC without a value computes it from
  SourceSpan where;
};

/// A computation with a name, of one module: gets the messages it reads, gives the messages it writes. `time`
/// is what it takes where an environment says nothing else (pal/pan/times.hpp).
struct Activity {
  std::string name;
  ModuleId module;
  std::vector<MessageId> reads;
  std::vector<MessageId> writes;
  SourceSpan where;
  std::optional<Interval> time{};
};

struct Module {
  std::string name;
  ModuleKind kind;
  Graph body;              // empty: the environment describes it as a device
  ModuleId executed_by{};  // valid: runs only by Execute, inside that module
  std::vector<std::string>
      threads;  // "SM1", then its CONCURRENT blocks "SM1.1", "SM1.2", … in the order of the text
  SourceSpan where;
  std::vector<std::string> descriptions;  // texts of its template
  std::vector<std::string> methods;       // of a logical sensor: how it gets what it returns
  // Of a logical sensor: the drivers and messages that its template names, as its body has them; nothing if
  // it does not say.
  std::optional<std::vector<std::string>> drivers;
  std::optional<std::vector<std::string>> returns;
};

/// Something outside the skill that sends, answers or takes messages.
struct Device {
  std::string name;
  std::string description;
  SourceSpan where;
};

/// A parameter of the skill. Range and default are in `unit`; low <= default <= high. A text has neither
/// unit nor range.
struct Parameter {
  std::string name;
  ScalarType type = ScalarType::real;
  bool location = false;  // a text: a name of a location that is taught
  std::string unit;
  double low = 0;
  double high = 0;
  double default_value = 0;
  std::string default_text;  // of a text: printable ASCII
  std::string description;
  SourceSpan where;
};

/// A way in which the skill can end. The error completion also stands for every fault at run time.
struct Completion {
  enum class Kind { normal, contingency, error };
  int code = 0;
  Kind kind = Kind::normal;
  int contingency = 0;  // contingency: its number
  std::string description;
  SourceSpan where;
};

struct Contingency {
  int number = 0;
  std::string description;
  ModuleId method{};
  SourceSpan where;
};

/// The generic skill template (thesis, section 2.3.2); lists that the network holds elsewhere are not
/// repeated.
struct Template {
  std::string name;
  std::vector<std::string> descriptions;
  std::vector<std::string> preconditions;
  std::vector<std::string> postconditions;
  std::vector<std::string> model_data;
  std::vector<Parameter> parameters;
  std::vector<Contingency> contingencies;
  std::vector<Completion> completions;
  SourceSpan where;
};

struct Network {
  Template skill;
  ModuleId main{};  // the skill method: the module that waits for the coordinator
  std::vector<Module> modules;
  std::vector<Device> devices;
  std::vector<Message> messages;
  std::vector<Channel> channels;
  std::vector<Condition> conditions;
  std::vector<Activity> activities;
  std::vector<Requirement> requirements;
};

}  // namespace pal::pan
