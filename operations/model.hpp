// An operation: icons that an application programmer connects, through which one token goes (thesis, sections
// 2.3.4 and 4.4).
#pragma once

#include <compare>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pal/pan/network.hpp"
#include "pal/support/source.hpp"

namespace pal::operations {

/// The icon to which an output leads. An empty name: nowhere.
struct Connection {
  std::string icon;
  SourceSpan where;

  bool connected() const { return !icon.empty(); }
};

/// In the parameter's unit, as the skill declares it.
using Value = std::variant<double, bool, std::string>;

/// Where a value comes from that is known only when the operation runs.
struct Source {
  enum class Kind {
    written,   // it stands in the file
    count,     // how often `icon`, of the same operation, has ended normally since START
    argument,  // the argument `name` of the operation
    output     // what the skill of `icon`, of the same operation, reported last as `name`, since START
  };
  Kind kind = Kind::written;
  std::string icon{}, name{};

  bool written() const { return kind == Kind::written; }
};

struct Parameter {
  std::string name;
  Value value;
  SourceSpan where;  // of the value
  SourceSpan name_where;
  Source source{};
};

/// A number, in the unit of what it is compared with or of what it sets.
struct Amount {
  double number = 0;  // if it is written
  SourceSpan where{};
  Source source{};
};

/// What a test and a wait read, and what it is compared with.
struct Condition {
  std::string sensor;  // empty: `value` is read
  Amount value{};
  std::optional<Amount> at_least{}, at_most{};  // in the sensor's unit; nothing: the limits of the test
  /// What was met stays met until the reading is this much beyond, in the sensor's unit.
  double hysteresis = 0;
  int mean_of = 1;  // so many readings
  SourceSpan subject{};
};

/// A parameter that an operator may set at the cell, and within what: in the parameter's unit; nothing: its
/// whole range.
struct OperatorMaySet {
  std::string parameter;
  std::optional<double> from{}, to{};
  SourceSpan where{};
};

/// One output of a CASE; or an answer to a question, whose code is its place among the answers, from 0; or a
/// code of a planned skill, which leads nowhere by itself.
struct Way {
  std::vector<int> codes;
  Connection to;
  SourceSpan where;
  std::string text{};  // of an answer and a code
};

/// What must hold of a value that is known when it runs. A value that is missing does not meet it.
struct BreakCondition {
  Source source;  // not `written`; its icon is one of the operation in which the breakpoint lies
  std::optional<double> at_least{}, at_most{};
};

/// A breakpoint that the file keeps at its icon. It halts whatever path the token came on.
struct KeptBreakpoint {
  std::optional<int> code{};  // only if that was the last completion code
  std::optional<BreakCondition> condition{};
  std::size_t every = 1;  // at each so manieth arrival that fits
  bool enabled = true;
  SourceSpan where{};
};

struct Point {
  double x = 0, y = 0;
};

/// `branch` is the CASE icon; `test` the test of a sensor; `planned` stands for a skill that nobody has
/// written yet; `sub_operation` is the hierarchical icon.
enum class IconKind {
  start,
  skill,
  branch,
  merge,
  delay,
  wait,
  test,
  question,
  zero,
  planned,
  sub_operation,
  restart,
  exit
};

/// How the conditions of a test or a wait are combined; `one`: there is only one.
enum class Combination { one, all, any };

struct Icon {
  std::string id;
  IconKind kind = IconKind::merge;
  Connection next;                               // of all but CASE, question, RESTART and EXIT
  Connection error;                              // of what ends with a code: for codes that no CASE handles
  Connection otherwise;                          // of a CASE: its default
  std::vector<Way> ways;                         // of a CASE, a question and a planned skill
  std::string skill;                             // also of a planned one: what it is to be called
  std::vector<pan::Parameter> planned;           // the parameters that a planned skill is to have
  std::vector<Parameter> parameters;             // of a skill and a hierarchical icon
  std::vector<OperatorMaySet> operator_may_set;  // likewise
  std::optional<Amount> repeat{};  // of these: how often it runs; it ends early by a code that is not normal
  int retries = 0;                 // of a skill: how often it begins again if it does not end normally
  std::vector<int> retry_on;       // … with these codes only; empty: with any
  std::optional<Amount> time_limit{};  // of a skill, s
  std::optional<Amount> seconds{};     // of a delay
  std::vector<Condition> conditions;   // of a wait and a test
  Combination combination = Combination::one;
  std::vector<Amount> limits;       // of a test, ascending, in the sensor's unit
  std::optional<Amount> timeout{};  // of a wait and a question, s; nothing: it waits for ever
  std::string text;                 // of a question
  std::string sensor;               // of a zero: one of the device's
  std::optional<Amount> code{};     // of an exit; without one, the last completion code goes on
  std::string operation;            // of a hierarchical icon: the sub-operation's name
  std::string file;                 // … and the file it stands in; empty: this one
  std::optional<Point> at{};        // on a canvas
  std::optional<KeptBreakpoint> breakpoint{};
  std::string note;
  SourceSpan where;    // its id
  SourceSpan subject;  // its skill, sensor, operation or file
};

/// The operation that runs when another one is stopped.
struct OnStop {
  std::string operation, file;  // as of a hierarchical icon; both empty: none
  SourceSpan where;

  bool given() const { return !operation.empty() || !file.empty(); }
};

struct Operation {
  std::string name;
  std::string description;
  /// What a hierarchical icon may set as its parameters. Each has a default.
  std::vector<pan::Parameter> arguments;
  OnStop on_stop;
  std::vector<Icon> icons;
  SourceSpan where;
  std::string from{};  // the file that it stands in
};

/// An object of a file that is an icon, whether it could be read or not.
struct Extent {
  SourceSpan where;  // from its brace to its brace
  std::string operation, icon;
};

/// One file: its operation first, then those that its hierarchical icons may name.
struct Document {
  std::vector<Operation> operations;
  std::vector<Extent> extents;  // in the order of the text
};

/// An operation with all that its hierarchical icons stand for, in whatever file.
struct Program {
  std::vector<Operation> operations;  // the first is the one to run
  std::vector<Extent> extents;        // by file, in the order of the text
};

/// The icon in whose object the place lies; nothing if it lies in none.
std::optional<Extent> extent_of(const Program& program, SourceSpan where);

/// The index of the icon; nothing if there is none of this name.
std::optional<std::size_t> find_icon(const Operation& operation, const std::string& id);

/// The index of the operation that the hierarchical `icon` of `from` stands for; nothing if it is not there.
std::optional<std::size_t> find_sub_operation(const Program& program, const Operation& from,
                                              const Icon& icon);

/// The place of an icon: the index of its operation, and its own index in it.
struct Place {
  std::size_t operation = 0, icon = 0;
  friend auto operator<=>(const Place&, const Place&) = default;
};
/// Stands in a path for the operation that ran because the one before it was stopped. No icon is called so.
inline constexpr const char* on_stop_in_path = "on-stop";
/// The icons from the first operation down to "rub-in-square/side-1", which is the last; nothing if one of
/// them is not there. The operation of "on-stop/lift" is the one on stop, and has no icon of its own.
std::vector<Place> find_path(const Program& program, const std::string& path);

/// All outputs of an icon that are connected, in the order of the file.
std::vector<Connection> outputs(const Icon& icon);

/// The code of an icon for which a value is missing: a sensor, a figure or a person gave none.
inline constexpr int no_value = -1;
/// The code of a skill whose time limit is over, and of a question to which nobody answered in time.
inline constexpr int time_over = -2;
/// The code of a wait whose time was over before its sensor showed what it waited for.
inline constexpr int waited_in_vain = 1;
/// In a set of codes: any that is not known before the operation runs.
inline constexpr int any_code = std::numeric_limits<int>::min();
/// "3", or "any other".
std::string code_text(int code);

/// "at least 10", "from 10 to 20", …
std::string condition_text(const Condition& condition);
/// What is read: "force-z", "the count of put", "force of press".
std::string subject_text(const Condition& condition);
/// Of all conditions: "force-z at least 10 and gripper-width from 1 to 2".
std::string conditions_text(const Icon& icon);
/// What a wait, a test or a zero is about: "force-z", "force-z, gripper-width".
std::string subjects_text(const Icon& icon);
/// What a person is asked. Of a planned skill its name, its parameters and its note: "insert-pin (depth = 5
/// mm): Push it in." Empty: the icon asks nobody.
std::string question_text(const Icon& icon);

/// "start", "skill", "case", …, as in a file.
const char* name(IconKind kind);
std::optional<IconKind> icon_kind(const std::string& name);
const std::vector<std::string>& icon_kind_names();

/// "5", "true", "\"HOME\"".
std::string to_text(const Value& value);
/// A value as typed: true, false, a number, or a text with or without quotation marks.
Value parse_value(const std::string& text);
/// "the count of put", "the argument force", "force of press"; empty for what is written.
std::string to_text(const Source& source);
/// As to_text() of its value or of its source.
std::string to_text(const Parameter& parameter);
std::string to_text(const Amount& amount);

}  // namespace pal::operations
