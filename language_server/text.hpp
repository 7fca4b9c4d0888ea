// A text with its lines, and places in it as the protocol counts them: lines and UTF-16 columns from 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pal::language_server {

struct Position {
  std::uint32_t line = 0;
  std::uint32_t character = 0;
  friend auto operator<=>(const Position&, const Position&) = default;
};

/// The text with its ASCII letters in capitals.
std::string capitals(std::string_view text);

class Text {
 public:
  Text() : Text(std::string()) {}
  explicit Text(std::string content);

  const std::string& content() const { return content_; }
  std::size_t lines() const { return starts_.size(); }

  /// The byte at a position. Behind the end of a line: the end of the line; behind the last line: the end.
  std::uint32_t offset(Position position) const;
  Position position(std::size_t offset) const;
  /// A line without its break; empty if there is none.
  std::string_view line(std::size_t number) const;

  /// Replaces what is between the two; if they are in the wrong order, what is between the second and the
  /// first.
  void replace(Position from, Position to, std::string_view by);

 private:
  void find_lines();

  std::string content_;
  std::vector<std::uint32_t> starts_;  // of lines; \n, \r\n and \r break them
};

}  // namespace pal::language_server
