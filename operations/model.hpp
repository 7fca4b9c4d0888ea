// An operation: icons that an application programmer connects, through which one token goes (thesis, sections
// 2.3.4 and 4.4).
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pal/support/source.hpp"

namespace pal::operations {

/// Where an output of an icon leads. An empty name: nowhere.
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
  /// Not empty: the value is how often this icon, of the same operation, has ended normally since START.
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

/// `branch` is the CASE icon; `sub_operation` the hierarchical icon.
enum class IconKind { start, skill, branch, merge, delay, sub_operation, restart, exit };

struct Icon {
  std::string id;
  IconKind kind = IconKind::merge;
  Connection next;       // of start, skill, merge, delay, sub_operation
  Connection error;      // of skill and sub_operation: for codes that nobody else handles
  Connection otherwise;  // of a CASE: its default
  std::vector<Way> ways;
  std::string skill;
  std::vector<Parameter> parameters;
  double seconds = 0;         // of a delay
  std::optional<int> code;    // of an exit; without one, the last completion code goes on
  std::string operation;      // of a hierarchical icon: the sub-operation's name
  std::string file;           // … and the file it stands in; empty: this one
  std::optional<Point> at{};  // on a canvas
  std::string note;
  SourceSpan where;    // its id
  SourceSpan subject;  // its skill, operation or file
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

/// All outputs of an icon that are connected, in the order of the file.
std::vector<Connection> outputs(const Icon& icon);

/// "start", "skill", "case", …, as in a file.
const char* name(IconKind kind);
std::optional<IconKind> icon_kind(const std::string& name);
const std::vector<std::string>& icon_kind_names();

/// "5", "true", "\"HOME\"".
std::string to_text(const Value& value);
/// Likewise; of a count "the count of put".
std::string to_text(const Parameter& parameter);

}  // namespace pal::operations
