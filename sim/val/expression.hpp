// The words, numbers and locations of a line.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/val/store.hpp"

namespace pal::sim::val {

/// Longest name of a location, a number or a program.
inline constexpr std::size_t longest_name = 20;

/// Reads a line from left to right; letters count as capitals. What is missing or wrong is thrown as Error.
class Line {
 public:
  explicit Line(std::string_view text);

  bool done();
  /// The next word (a letter, then letters, digits and underscores), if there is one.
  std::optional<std::string> word();
  /// As word(), but nothing is taken.
  std::optional<std::string> look();
  bool take(char symbol);
  void expect(char symbol);
  /// A word that may name something.
  std::string name();
  std::optional<double> literal();
  /// Nothing may follow.
  void end();

 private:
  void skip();

  std::string text_;
  std::size_t at_ = 0;
};

/// What expressions are worked out from.
struct Values {
  const Store& store;
  Pose here;  // relative to the base
};

/// A number or the name of one.
double number(Line& line, const Values& values);
/// The same, which must be whole and within the two.
long whole_number(Line& line, const Values& values, long least, long most);
/// `a`, `a:b`, HERE, NULL, TRANS(x,y,z,o,a,t), SHIFT(a BY dx,dy,dz), INVERSE(a).
Pose location(Line& line, const Values& values);

}  // namespace pal::sim::val
