// An operation: icons that an application programmer connects, through which one token goes (thesis, sections
// 2.3.4 and 4.4).
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <variant>
#include <vector>

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

struct Parameter {
  std::string name;
  Value value;
  SourceSpan where;  // of the value
  SourceSpan name_where;
  /// Not empty: the value is the number of times that this icon, of the same operation, has ended normally
  /// since START.
  std::string count_of{};
};

/// One output of a CASE.
struct Way {
  std::vector<int> codes;
  Connection to;
  SourceSpan where;
};

struct Point {
  double x = 0, y = 0;
};

/// `branch` is the CASE icon; `test` the test of a sensor; `sub_operation` the hierarchical icon.
enum class IconKind { start, skill, branch, merge, delay, wait, test, sub_operation, restart, exit };

struct Icon {
  std::string id;
  IconKind kind = IconKind::merge;
  Connection next;       // of all but CASE, RESTART and EXIT
  Connection error;      // of skill, wait, test and sub_operation: for codes that no CASE handles
  Connection otherwise;  // of a CASE: its default
  std::vector<Way> ways;
  std::string skill;
  std::vector<Parameter> parameters;
  double seconds = 0;                           // of a delay
  std::string sensor;                           // of a wait and a test
  std::vector<double> limits;                   // of a test, ascending, in the sensor's unit
  std::optional<double> at_least{}, at_most{};  // of a wait: what it waits for, in the sensor's unit
  std::optional<double> timeout{};              // of a wait, s; nothing: it waits for ever
  std::optional<int> code;                      // of an exit; without one, the last completion code goes on
  std::string operation;                        // of a hierarchical icon: the sub-operation's name
  std::string file;                             // … and the file it stands in; empty: this one
  std::optional<Point> at{};                    // on a canvas
  std::string note;
  SourceSpan where;    // its id
  SourceSpan subject;  // its skill, sensor, operation or file
};

struct Operation {
  std::string name;
  std::string description;
  std::vector<Icon> icons;
  SourceSpan where;
  std::string from{};  // the file that it stands in
};

/// One file: its operation first, then those that its hierarchical icons may name.
struct Document {
  std::vector<Operation> operations;
};

/// An operation with all that its hierarchical icons stand for, in whatever file.
struct Program {
  std::vector<Operation> operations;  // the first is the one to run
};

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
/// The icons from the first operation down to "rub-in-square/side-1", which is the last; nothing if one of
/// them is not there.
std::vector<Place> find_path(const Program& program, const std::string& path);

/// All outputs of an icon that are connected, in the order of the file.
std::vector<Connection> outputs(const Icon& icon);

/// The code of a test or a wait whose sensor gave no value.
inline constexpr int sensor_failed = -1;
/// The code of a wait whose time was over before its sensor showed what it waited for.
inline constexpr int waited_in_vain = 1;
/// The code of a test: how many of its limits the reading has reached.
int code_of(const Icon& test, double reading);
/// Whether a wait has come to its end.
bool is_met(const Icon& wait, double reading);
/// "at least 10", "from 10 to 20", …
std::string condition_text(const Icon& wait);

/// "start", "skill", "case", …, as in a file.
const char* name(IconKind kind);
std::optional<IconKind> icon_kind(const std::string& name);
const std::vector<std::string>& icon_kind_names();

/// "5", "true", "\"HOME\"".
std::string to_text(const Value& value);
/// A value as typed: true, false, a number, or a text with or without quotation marks.
Value parse_value(const std::string& text);
/// As to_text(); of a count "the count of put".
std::string to_text(const Parameter& parameter);

}  // namespace pal::operations
