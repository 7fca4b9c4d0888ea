// Text of C++, line by line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "codegen/plan.hpp"

namespace pal::codegen {

/// Lines with two spaces of indentation a level.
class Writer {
 public:
  /// An empty `text` gives an empty line.
  Writer& line(std::string_view text = {});
  /// Ends in "{"; the lines that follow are indented.
  Writer& open(std::string_view text);
  /// Ends the indentation, then writes the line.
  Writer& close(std::string_view text = "}");
  /// `before`, the items with commas between, `after`: in one line if it fits, otherwise over several.
  Writer& list(const std::string& before, const std::vector<std::string>& items, const std::string& after);
  /// `before`, an expression of && and ||, `after`, likewise.
  Writer& condition(const std::string& before, const std::string& expression, const std::string& after);
  Writer& indent();
  Writer& outdent();

  /// From here on, debuggers show line `line` of `file` for the lines of code, by a #line before each.
  Writer& stands_for(std::string_view file, int line);
  /// From here on, debuggers show the lines of code themselves, in a file called `own`.
  Writer& stands_for_itself(std::string_view own);

  std::string take() { return std::move(text_); }

 private:
  /// `row` and the parts, spaces between them, broken where the line would be too long.
  Writer& fill(std::string row, const std::vector<std::string>& parts);

  std::string text_;
  std::string origin_;  // a #line; empty: none
  std::size_t level_ = 0;
};

/// The first lines of every generated file.
void write_heading(Writer& out, const Plan& plan, std::string_view what);
void open_namespace(Writer& out, const Plan& plan);
void close_namespace(Writer& out, const Plan& plan);

/// "double", "std::int64_t", "bool", "runtime::Text"; of an array "std::array<double, 255>".
std::string cpp_type(pan::ScalarType type, int size = 0);
/// A number that reads back as itself: "20", "0.5"; of type bool "true", "false".
std::string number(double value, pan::ScalarType type);
/// "28ms", "50us", "1s": the greatest unit in which it is whole.
std::string duration(Duration value);
/// "{100us, 200us}".
std::string interval(const Interval& value);

}  // namespace pal::codegen
