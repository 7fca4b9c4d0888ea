// A paragraph for people that knows which lines of programs it names.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pal::analyzer {

class Told {
 public:
  Told() = default;
  Told(std::string text) : pieces_{{std::move(text), {}, 0}} {}  // NOLINT: any text is one without lines
  Told(const char* text) : Told(std::string(text)) {}            // NOLINT
  /// The number of a line, in digits.
  static Told line(std::string file, int number);

  std::string text() const;

  Told& operator+=(const Told& more);
  friend Told operator+(Told one, const Told& other) { return std::move(one += other); }

  /// With the lines that `move` makes of them. Nothing: it says false of one.
  std::optional<Told> with_lines(const std::function<bool(const std::string& file, int& line)>& move) const;

 private:
  /// A text, and the line that is named after it.
  struct Piece {
    std::string text;
    std::string file;
    int line = 0;  // 0: none
  };
  std::vector<Piece> pieces_;
};

}  // namespace pal::analyzer
