// A formula of a skill's parameters, such as the longest time that it takes: "reach / approach-speed + 2".
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pal::operations {

/// All numbers from `low` to `high`, both included.
struct ValueRange {
  double low = 0, high = 0;
};

/// Sums, products and quotients of numbers and names, with parentheses, abs(x), max(x, …) and norm(x, …), the
/// root of the sum of squares. Blanks stand around + and -, for names have hyphens.
class Formula {
 public:
  /// Nothing: the text is none.
  static std::optional<Formula> parse(const std::string& text);

  const std::string& text() const { return text_; }

  /// What is known of a name; nothing: it is not known.
  using Values = std::function<std::optional<ValueRange>(const std::string& name)>;
  /// Contains every value that the formula has for values of the names in their intervals. Nothing: a name is
  /// not known, or there is no bound.
  std::optional<ValueRange> over(const Values& values) const;

 private:
  friend class FormulaReader;
  enum class Kind { number, name, add, subtract, multiply, divide, abs, max, norm };
  struct Step {
    Kind kind = Kind::number;
    double number = 0;
    std::string name{};
    std::size_t count = 2;  // of operands
  };

  std::string text_;
  std::vector<Step> steps_;  // each takes its operands from those before it, and stands for its value
};

}  // namespace pal::operations
